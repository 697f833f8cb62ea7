// The library's errors: a code for programs to act on and a text for people. A function that needs
// more memory than there is throws std::bad_alloc.
//
// For example:
//
//     #include "collision_hulls/mesh/mesh_io.h"
//
//     try {
//       readMesh(file);
//     } catch (const Error& error) {
//       if (error.code() == ErrorCode::kFileNotFound) return;
//       std::cerr << error.what() << '\n';
//     }
#pragma once

#include <stdexcept>
#include <string>

namespace collision_hulls {

enum class ErrorCode {
  kFileNotFound,         ///< the path does not exist or cannot be read
  kPackageNotFound,      ///< a package:// URI names a package that is not on the search path
  kUnsupportedFormat,    ///< the file's extension is not one that can be read or written
  kNotAMesh,             ///< the file's content does not match its extension
  kEmptyMesh,            ///< there are no triangles, or no points to make a hull of
  kTooLarge,             ///< more bytes, triangles, bodies, pairs or metres than the limit
  kNonFiniteCoordinate,  ///< a vertex coordinate is NaN or infinite
  kIndexOutOfRange,      ///< a face refers to a vertex that does not exist
  kTooFarFromOrigin,     ///< the mesh lies so far out that single precision cannot resolve it
  kReaderFailed,         ///< the file's reader crashed, cannot start, or gave no valid answer
  kBadScale,             ///< a URDF scale factor is zero or not finite
  kNotXml,               ///< the robot description is not well-formed XML
  kNotARobot,            ///< well-formed XML, but not a robot description
  kBadGeometry,          ///< a visual or collision element of the robot description cannot be read
  kNoLinks,              ///< the robot description has no links
  kBadScene,             ///< not a scene description, or one with something that cannot be a body
  kBadConfigurations,    ///< not a list of configurations, or one for another robot
  kNotAnSrdf,            ///< well-formed XML, but not a semantic robot description
  kXacroMissing,         ///< the input is a .xacro file and no xacro program is installed
  kBadOption,            ///< an option's value is out of range
  kUnwritableOutput,     ///< the output folder cannot be created or written
  kNotAHullTree,         ///< not a hull tree file, or a damaged one, or one of another version
  kOutsideRoots,         ///< the path lies outside the folders that may be read or written
  kNotOurOutput,         ///< the output path holds something that this library did not write
  kOutOfMemory,          ///< a reader, a mesh of a run or a new thread lacked memory
  kOutOfTime,            ///< the time that was allowed did not suffice
  kCancelled,            ///< the caller cancelled the run
  kInternal              ///< the library's own output failed a check
};

/// The enumerator's name without its k, as used in reports: "FileNotFound".
const char* name(ErrorCode code);

/// Thrown for every expected failure. what() names the item, its value, the limit and the remedy;
/// of a text beyond 4,000 bytes, which only quotes of a hostile file make, it has the start and the
/// end, and '?' for control characters other than line ends and tabs, which a terminal would obey.
class Error : public std::runtime_error {
 public:
  Error(ErrorCode code, const std::string& text);
  ErrorCode code() const { return code_; }

 private:
  ErrorCode code_;
};

}  // namespace collision_hulls
