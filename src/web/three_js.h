// three.js, where the system has it.
#pragma once

#include <filesystem>
#include <string>

namespace collision_hulls {

/// Where Debian's and Ubuntu's package libjs-three puts it.
constexpr const char* kThreeJsFile = "/usr/share/javascript/three/three.min.js";

/// The library's text, to stand in a page's <script>; empty if the file is not there, cannot stand in a <script> as it is, or could have
/// been written by others than root and this user.
std::string threeJs(const std::filesystem::path& file = kThreeJsFile);

/// Its copyright and licence, which every copy has to hold: Debian's file has neither.
const char* threeJsNotice();

}  // namespace collision_hulls
