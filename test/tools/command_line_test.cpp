// Arguments that a command line accepts, and the messages for those that it refuses.
#include "tools/command_line.h"

#include <gtest/gtest.h>

#include <array>
#include <map>

#include "collision_hulls/error.h"
#include "scoped_variable.h"

namespace collision_hulls {
namespace {

class CommandLineTest : public ::testing::Test {
 protected:
  CommandLineTest() {
    line_.add_option("INPUT", input_, "What to read")->required();
    line_.add_option("-o,--output", output_, "Where to write")->type_name("DIR")->check(notEmpty("a folder"));
    line_.add_option("--count", count_, "How many")->type_name("N [3]")->check(range(1, 10))->group("Numbers");
    line_.add_option("--factor", factor_, "How much")->group("Numbers");
    line_.add_option("--peer", peers_, "Others");
    line_.add_flag("--quiet", quiet_, "Say nothing");
    line_.add_option_function(
        "--first", [this](const std::string& text) { calls_ += "first " + text + " "; }, "Called");
    line_.add_option_function(
        "--second", [this](const std::string& text) { calls_ += "second " + text + " "; }, "Called");
  }

  bool parse(std::vector<const char*> arguments) {
    arguments.insert(arguments.begin(), "program");
    return line_.parse(static_cast<int>(arguments.size()), arguments.data());
  }

  void expectRefused(const std::vector<const char*>& arguments, const std::string& message) {
    try {
      parse(arguments);
      ADD_FAILURE() << "accepted; expected the message: " << message;
    } catch (const Error& e) {
      EXPECT_EQ(e.code(), ErrorCode::kBadOption);
      EXPECT_EQ(e.what(), message + (message.back() == '?' ? " See program --help" : "; see program --help"));
    }
  }

  std::string input_, output_, calls_;
  std::vector<std::string> peers_;
  int count_ = 3;
  double factor_ = 1;
  bool quiet_ = false;
  CommandLine line_{"Tests.", "program"};
};

TEST_F(CommandLineTest, OptionsFillTheirVariables) {
  EXPECT_TRUE(parse({"--count=7", "in", "-o", "out", "--factor", "1e-3", "--peer", "a", "--peer", "b", "--quiet"}));
  EXPECT_EQ(input_, "in");
  EXPECT_EQ(output_, "out");
  EXPECT_EQ(count_, 7);
  EXPECT_EQ(factor_, 1e-3);
  EXPECT_EQ(peers_, (std::vector<std::string>{"a", "b"}));
  EXPECT_TRUE(quiet_);
}

TEST_F(CommandLineTest, WhatWasGivenIsWordsOfAShell) {
  parse({"--quiet", "in", "--peer", "it's", "-o", "out dir", "--factor=-2", "--peer=b"});
  EXPECT_EQ(line_.given(), "--output 'out dir' --factor=-2 --peer 'it'\\''s' --peer b --quiet");
  parse({"in"});
  EXPECT_EQ(line_.given(), "");
}

TEST_F(CommandLineTest, OptionsThatTakeAValueAreKnownByName) {
  const std::pair<bool, bool> none{false, false}, one{true, false}, several{true, true};
  const std::map<std::string, std::pair<bool, bool>> expected{{"help", none},  {"version", none}, {"output", one},
                                                              {"count", one},  {"factor", one},   {"peer", several},
                                                              {"quiet", none}, {"first", one},    {"second", one}};
  EXPECT_EQ(line_.takesValue(), expected);
}

TEST_F(CommandLineTest, FunctionsAreCalledInTheOrderOfDeclaration) {
  EXPECT_TRUE(parse({"--second", "2", "in", "--first", "1"}));
  EXPECT_EQ(calls_, "first 1 second 2 ");
}

TEST_F(CommandLineTest, ValuesMayBeginWithADash) {
  EXPECT_TRUE(parse({"-o-", "--factor", "-2", "--", "--strange"}));
  EXPECT_EQ(output_, "-");
  EXPECT_EQ(factor_, -2);
  EXPECT_EQ(input_, "--strange");
}

TEST_F(CommandLineTest, AnUnknownOptionSuggestsTheNearest) {
  expectRefused({"in", "--ouptut", "out"}, "there is no option --ouptut; did you mean '--output'?");
  expectRefused({"in", "--out", "out"}, "there is no option --out; did you mean '--output'?");
  expectRefused({"in", "--counts=3"}, "there is no option --counts; did you mean '--count'?");
  expectRefused({"in", "--velocity", "3"}, "there is no option --velocity");
  expectRefused({"in", "-x"}, "there is no option -x");
}

TEST_F(CommandLineTest, WrongValuesAreNamed) {
  expectRefused({"in", "--count", "few"}, "--count 'few' is not understood: it takes a number from 1 to 10");
  expectRefused({"in", "--count", "11"}, "--count '11' is not understood: it takes a number from 1 to 10");
  expectRefused({"in", "--count", "2.5"}, "--count '2.5' is not understood: it takes a whole number");
  expectRefused({"in", "--factor", "2m"}, "--factor '2m' is not understood: it takes a number");
  expectRefused({"in", "-o", ""}, "--output '' is not understood: it takes a folder");
}

TEST_F(CommandLineTest, AnOptionIsNotAValue) {
  expectRefused({"in", "--output", "--factor", "2"}, "--output lacks its value: '--factor' is another option");
  EXPECT_TRUE(parse({"in", "--output=--factor"}));
  EXPECT_EQ(output_, "--factor");
}

TEST_F(CommandLineTest, WhatIsMissingOrTooMuchIsNamed) {
  expectRefused({}, "INPUT is required");
  expectRefused({"in", "another"}, "unexpected argument 'another'");
  expectRefused(
      {"in", "hand:=true"},
      "unexpected argument 'hand:=true': give it to xacro itself, as in 'xacro FILE.xacro hand:=true > FILE.urdf', and give the .urdf");
  expectRefused({"in", "-o", "a", "--output", "b"}, "--output is given twice: 'a' and 'b'");
  expectRefused({"in", "--output"}, "the required argument for option '--output' is missing");
  expectRefused({"in", "--quiet=1"}, "option '--quiet' does not take any arguments");
}

class AssignmentsTest : public CommandLineTest {
 protected:
  AssignmentsTest() { line_.add_assignments(assigned_, "Values"); }
  std::vector<std::string> assigned_;
};

TEST_F(AssignmentsTest, StandInAnyPlace) {
  EXPECT_TRUE(parse({"a:=1", "--count", "2", "in", "b:=c d", "--", "e:="}));
  EXPECT_EQ(input_, "in");
  EXPECT_EQ(assigned_, (std::vector<std::string>{"a:=1", "b:=c d", "e:="}));
  EXPECT_EQ(line_.given(), "--count 2 a:=1 'b:=c d' e:=");
  EXPECT_NE(line_.help().find("INPUT [NAME:=VALUE...]"), std::string::npos);
}

TEST_F(AssignmentsTest, AreNotPathsNorValuesOfOptions) {
  EXPECT_TRUE(parse({"./a:=1", "-o", "b:=2"}));
  EXPECT_EQ(input_, "./a:=1");
  EXPECT_EQ(output_, "b:=2");
  EXPECT_TRUE(assigned_.empty());
}

TEST(CommandLine, TheLastArgumentTakesAllThatAreLeft) {
  CommandLine line("Tests.", "program");
  std::string first;
  std::vector<std::string> others, assigned;
  line.add_option("FIRST", first, "One");
  line.add_assignments(assigned, "Values");
  line.add_option("OTHERS", others, "Others");
  const std::array<const char*, 5> arguments{"program", "a", "x:=1", "b", "c"};
  EXPECT_TRUE(line.parse(static_cast<int>(arguments.size()), arguments.data()));
  EXPECT_EQ(first, "a");
  EXPECT_EQ(others, (std::vector<std::string>{"b", "c"}));
  EXPECT_EQ(assigned, std::vector<std::string>{"x:=1"});
}

TEST_F(AssignmentsTest, DoNotStandForOtherArguments) {
  expectRefused({"a:=1"}, "INPUT is required");
  expectRefused({"in", ":=1"}, "unexpected argument ':=1': an argument for xacro is NAME:=VALUE, as in prefix:=left_");
}

TEST_F(CommandLineTest, HowItWasCalled) {
  const auto called_as = [&](const char* path) {
    const std::array<const char*, 2> arguments{path, "in"};
    EXPECT_TRUE(line_.parse(2, arguments.data()));
    return line_.call();
  };
  const ScopedVariable spaces("CMAKE_PREFIX_PATH", "/opt/ros/noetic:/home/me/my ws/devel");
  EXPECT_EQ(called_as("program"), "program");
  EXPECT_EQ(called_as("/home/me/my ws/devel/lib/collision_hulls/program"), "rosrun collision_hulls program");
  EXPECT_EQ(called_as("/home/me/my ws/build/lib/collision_hulls/program"), "'/home/me/my ws/build/lib/collision_hulls/program'");
  EXPECT_EQ(called_as("./program"), "./program");
}

TEST_F(CommandLineTest, HelpAndVersionNeedNothingElse) {
  for (const char* option : {"-h", "--help", "--version"}) EXPECT_FALSE(parse({option})) << option;
}

TEST_F(CommandLineTest, HelpListsOptionsByGroup) {
  line_.footer("The end.");
  EXPECT_EQ(line_.help(), R"(Tests.
Usage: program [OPTIONS] INPUT

  INPUT                       What to read

Options:
  -h,--help                   Print this help and exit
  --version                   Print the version and exit
  -o,--output DIR             Where to write
  --peer                      Others
  --quiet                     Say nothing
  --first                     Called
  --second                    Called

Numbers:
  --count N [3]               How many
  --factor                    How much
The end.
)");
}

TEST_F(CommandLineTest, HelpLeavesOutWhatIsHidden) {
  line_.hide({"output", "count", "factor"});
  const std::string help = line_.help();
  EXPECT_EQ(help.find("--output"), std::string::npos) << help;
  EXPECT_EQ(help.find("Numbers:"), std::string::npos) << help;
  EXPECT_NE(help.find("--quiet"), std::string::npos) << help;
  EXPECT_TRUE(parse({"in", "-o", "out"}));
  EXPECT_EQ(output_, "out") << "it is taken all the same";
}

}  // namespace
}  // namespace collision_hulls
