// From YAML to trees of values, in this process.
#pragma once

#include <string>
#include <vector>

#include "scene/yaml_question.h"

namespace collision_hulls {

/// What parseYaml() does.
std::vector<YamlTree> decodeYaml(const std::vector<YamlText>& documents, const std::string& file, ErrorCode code);

}  // namespace collision_hulls
