// The names of the error codes, as used in reports.
#include "collision_hulls/error.h"

#include <algorithm>

#include "base/string_parts.h"
#include "base/uri_text.h"

namespace collision_hulls {

namespace {

constexpr std::size_t kLongestText = 4000;  // [bytes]

// Quotes of a hostile file go to terminals, which obey escape sequences.
std::string plain(std::string text) {
  std::replace_if(text.begin(), text.end(), isTerminalControl, '?');
  return text;
}

}  // namespace

Error::Error(ErrorCode code, const std::string& text) : std::runtime_error(plain(shortened(text, kLongestText))), code_(code) {}

const char* name(ErrorCode code) {
  switch (code) {
    case ErrorCode::kFileNotFound: return "FileNotFound";
    case ErrorCode::kPackageNotFound: return "PackageNotFound";
    case ErrorCode::kUnsupportedFormat: return "UnsupportedFormat";
    case ErrorCode::kNotAMesh: return "NotAMesh";
    case ErrorCode::kEmptyMesh: return "EmptyMesh";
    case ErrorCode::kTooLarge: return "TooLarge";
    case ErrorCode::kNonFiniteCoordinate: return "NonFiniteCoordinate";
    case ErrorCode::kIndexOutOfRange: return "IndexOutOfRange";
    case ErrorCode::kTooFarFromOrigin: return "TooFarFromOrigin";
    case ErrorCode::kReaderFailed: return "ReaderFailed";
    case ErrorCode::kBadScale: return "BadScale";
    case ErrorCode::kNotXml: return "NotXml";
    case ErrorCode::kNotARobot: return "NotARobot";
    case ErrorCode::kBadGeometry: return "BadGeometry";
    case ErrorCode::kNoLinks: return "NoLinks";
    case ErrorCode::kBadScene: return "BadScene";
    case ErrorCode::kBadConfigurations: return "BadConfigurations";
    case ErrorCode::kNotAnSrdf: return "NotAnSrdf";
    case ErrorCode::kXacroMissing: return "XacroMissing";
    case ErrorCode::kBadOption: return "BadOption";
    case ErrorCode::kUnwritableOutput: return "UnwritableOutput";
    case ErrorCode::kNotAHullTree: return "NotAHullTree";
    case ErrorCode::kOutsideRoots: return "OutsideRoots";
    case ErrorCode::kNotOurOutput: return "NotOurOutput";
    case ErrorCode::kOutOfMemory: return "OutOfMemory";
    case ErrorCode::kOutOfTime: return "OutOfTime";
    case ErrorCode::kCancelled: return "Cancelled";
    case ErrorCode::kInternal: return "Internal";
  }
  return "Unknown";
}

}  // namespace collision_hulls
