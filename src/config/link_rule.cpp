// What matters follows from the action first, then from the method: LinkDecisions refuses a rule that says more.
#include "config/link_rule.h"

#include "config/link_fields.h"

namespace collision_hulls {
namespace {

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (std::string("^$\\.*+?()[]{}|").find(c) != std::string::npos) result += '\\';
    result += c;
  }
  return result;
}

/// Removes what only other actions and methods have.
void keepWhatMatters(const LinkOptions& options, LinkSettings& settings) {
  if (options.action != Action::kDecompose) {
    settings = {};
    settings.action = options.action;
  } else if (options.method != Method::kCertified) {
    settings.effort.reset();
    settings.fill.reset();
  }
}

}  // namespace

std::string expressionFor(const std::vector<std::string>& links) {
  std::string expression;
  for (const std::string& link : links) expression += (expression.empty() ? "" : "|") + escaped(link);
  return expression;
}

LinkRule ruleFor(const std::string& link, const LinkOptions& options) {
  LinkRule rule{expressionFor({link}), {}, ""};
  forEachLinkField([&](const char*, auto option, auto setting) { rule.settings.*setting = options.*option; });
  keepWhatMatters(options, rule.settings);
  return rule;
}

LinkRule differingRuleFor(const std::string& link, const LinkOptions& options, const LinkOptions& defaults) {
  LinkRule rule{expressionFor({link}), {}, ""};
  forEachLinkField([&](const char*, auto option, auto setting) {
    if (!(options.*option == defaults.*option)) rule.settings.*setting = options.*option;
  });
  keepWhatMatters(options, rule.settings);
  if (options.action == defaults.action) rule.settings.action.reset();
  return rule;
}

bool equalSettings(const LinkOptions& a, const LinkOptions& b) {
  bool same = equal(a.regions, b.regions);
  forEachLinkField([&](const char*, auto option, auto) { same = same && a.*option == b.*option; });
  return same;
}

bool hasSettings(const LinkRule& rule) {
  bool has = false;
  forEachLinkField([&](const char*, auto option, auto setting) {
    (void)option;
    has = has || (rule.settings.*setting).has_value();
  });
  return has;
}

}  // namespace collision_hulls
