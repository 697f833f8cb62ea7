// Rules for single links, as programs write them: a name instead of an expression.
#pragma once

#include <string>
#include <vector>

#include "collision_hulls/report/options.h"

namespace collision_hulls {

/// The regular expression that matches these names alone.
std::string expressionFor(const std::vector<std::string>& links);

/// The rule that gives this link alone these options. It leaves out what does not matter with its action and method, as it would contradict
/// them, and LinkOptions::tree, which no rule has.
LinkRule ruleFor(const std::string& link, const LinkOptions& options);

/// The same with only what differs from `defaults`; no setting at all where nothing does.
LinkRule differingRuleFor(const std::string& link, const LinkOptions& options, const LinkOptions& defaults);

/// Whether a rule sets anything.
bool hasSettings(const LinkRule& rule);

/// Whether all that a configuration says of a link is equal, but for the names of regions.
bool equalSettings(const LinkOptions& a, const LinkOptions& b);

}  // namespace collision_hulls
