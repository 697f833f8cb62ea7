// Errors of the library: a reason that a program can act on, and a text that a person can.
#pragma once

#include <stdexcept>
#include <string>

namespace collision_hulls {

enum class ErrorCode {
  kFileNotFound,         ///< the path does not exist or cannot be read
  kPackageNotFound,      ///< a package:// URI names a package that is not on the search path
  kUnsupportedFormat,    ///< the file's extension is none of those that are read or written
  kNotAMesh,             ///< the file's content is not what its extension says
  kEmptyMesh,            ///< no triangle in the file
  kTooLarge,             ///< file size or number of triangles above the limit
  kNonFiniteCoordinate,  ///< NaN or infinity among the vertices
  kIndexOutOfRange,      ///< a face names a vertex that does not exist
  kTooFarFromOrigin,     ///< single precision cannot resolve the mesh where it lies
  kBadScale,             ///< a URDF scale that is zero or not finite
  kNotXml,               ///< the robot description is not well-formed XML
  kNotARobot,            ///< well-formed, but no robot description
  kBadGeometry,          ///< a visual or collision element of a robot description that cannot be read
  kNoLinks,              ///< a robot description without links
  kBadScene,             ///< what describes a scene is none, or holds what cannot be a body
  kBadConfigurations,    ///< what describes configurations is none, or is of another robot
  kNotAnSrdf,            ///< well-formed, but no semantic robot description
  kXacroMissing,         ///< a .xacro was given and no xacro program is installed
  kBadOption,            ///< an option's value is out of its range
  kUnwritableOutput,     ///< the output folder cannot be created or written
  kNotAHullTree,         ///< the file is no hull tree, or is damaged, or of another version
  kNotOurOutput,         ///< the output path holds something that this program did not write
  kCancelled,            ///< the caller asked to stop
  kInternal              ///< a check of our own output failed
};

/// The enumerator's name without its k, as it stands in reports: "FileNotFound".
const char* name(ErrorCode code);

/// Thrown for every expected failure. what() names the item, the value, the limit and the remedy.
class Error : public std::runtime_error {
 public:
  Error(ErrorCode code, const std::string& text) : std::runtime_error(text), code_(code) {}
  ErrorCode code() const { return code_; }

 private:
  ErrorCode code_;
};

}  // namespace collision_hulls
