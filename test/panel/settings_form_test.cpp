// The form without rviz, a node or a screen: what its fields show, change and refuse.
#include "panel/settings_form.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QLabel>
#include <QLineEdit>
#include <optional>
#include <tuple>

#include "config/link_rule.h"
#include "panel/table_model.h"

namespace collision_hulls {
namespace {

class SettingsFormTest : public testing::Test {
 protected:
  SettingsFormTest() {
    row_.link = "hand";
    row_.facts.status = "ok";
    QObject::connect(&form_, &SettingsForm::changed, [this](const SettingsForm::Change& change, bool) {
      changed_ = row_.options;
      change(*changed_);
    });
  }

  void show() { form_.show({&row_}); }
  QLineEdit& line(const char* name) const { return *form_.findChild<QLineEdit*>(name); }
  /// As a person does: Qt takes text from insert() for typed.
  void type(const char* name, const QString& text) {
    line(name).clear();
    line(name).insert(text);
    Q_EMIT line(name).editingFinished();
  }
  std::string told() const { return form_.findChild<QLabel*>("effect")->text().toStdString(); }

  LinkRow row_;
  SettingsForm form_;
  std::optional<LinkOptions> changed_;  // what somebody typed makes of the link's settings
};

TEST_F(SettingsFormTest, ShowsTheOpeningsThatAreClosed) {
  show();
  EXPECT_EQ("0", line("close_openings").text());
  row_.options.close_openings = 0.05;
  show();
  EXPECT_EQ("5cm", line("close_openings").text());
  EXPECT_FALSE(changed_);
}

TEST_F(SettingsFormTest, ATypedWidthOfOpeningsChangesNothingElse) {
  row_.options.padding = 0.01;
  show();
  type("close_openings", " 12cm ");
  LinkOptions expected = row_.options;
  expected.close_openings = 0.12;
  ASSERT_TRUE(changed_);
  EXPECT_TRUE(equalSettings(expected, *changed_));
  row_.options = expected;
  show();
  type("close_openings", "0");
  EXPECT_EQ(0, changed_->close_openings);
}

TEST_F(SettingsFormTest, WhatIsRefusedIsNamedWithItsValue) {
  show();
  for (const auto& [field, text, message] :
       {std::tuple("close_openings", "wide", "close openings 'wide' is invalid: use 0 or a positive length"),
        std::tuple("close_openings", "20", "close openings '20' is more than 1 m"),
        std::tuple("close_openings", "5%", "close openings '5%' is invalid"), std::tuple("tolerance_text", "seven", "tolerance 'seven' is"),
        std::tuple("tolerance_text", "20", "tolerance '20' is more than 1 m")}) {
    type(field, text);
    EXPECT_EQ(0u, told().find(message)) << told();
    EXPECT_FALSE(changed_);
  }
}

TEST_F(SettingsFormTest, CountsHullsAndPrimitives) {
  const auto tell = [&](std::size_t hulls, std::size_t primitives) {
    row_.facts.hulls = hulls;
    row_.facts.primitives = primitives;
    show();
    return told();
  };
  EXPECT_EQ("<b>1 hull</b>", tell(1, 0));
  EXPECT_EQ("<b>12 primitives</b>", tell(0, 12));
  EXPECT_EQ("<b>3 hulls and 1 primitive</b>", tell(3, 1));
  LinkTable links;
  links.take({row_});
  const TableModel table(links);
  EXPECT_EQ("3 hulls and 1 primitive", table.data(table.index(0, TableModel::kHulls), Qt::DisplayRole).toString());
  EXPECT_EQ(4, table.data(table.index(0, TableModel::kHulls), TableModel::kSortRole).toInt());
}

TEST_F(SettingsFormTest, OpeningsOfALinkThatIsKeptAreNotAsked) {
  form_.show({});
  EXPECT_FALSE(line("close_openings").isEnabled());
  show();
  EXPECT_TRUE(line("close_openings").isEnabled());
  row_.options.action = Action::kKeep;
  show();
  EXPECT_FALSE(line("close_openings").isEnabled());
}

}  // namespace
}  // namespace collision_hulls

int main(int argc, char** argv) {
  qputenv("QT_QPA_PLATFORM", "offscreen");
  const QApplication app(argc, argv);
  testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
