// Expands .xacro files through the user's xacro program.
#pragma once

#include <string>
#include <vector>

#include "collision_hulls/control.h"

namespace collision_hulls {

/// What xacro makes of a file, with values for its arguments (NAME:=VALUE). It finds the package that the file lies in, those beside it,
/// and those of `package_path`. Throws kXacroMissing, kPackageNotFound, kNotARobot, kTooLarge, kOutOfTime and kCancelled; kBadOption for an
/// argument of another form, one whose value xacro would drop, one that is given twice, and one that neither the file nor what it includes
/// has.
std::string expandXacro(const std::string& path, const std::vector<std::string>& arguments, const std::vector<std::string>& package_path,
                        const RunControl& control);

/// Refuses arguments for a file that is not a .xacro file. Throws kBadOption.
void checkTakesArguments(const std::string& path, const std::vector<std::string>& arguments);

}  // namespace collision_hulls
