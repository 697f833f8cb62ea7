// The program collision_hulls_reader: what it can be asked to read, and what it may use for that.
#pragma once

#include "sandbox/reader_program.h"

namespace collision_hulls {

/// The first value of a question's head.
enum class Reading : char { kMesh = 'm', kBufferFiles = 'b', kRobot = 'r', kXml = 'x', kYaml = 'y' };

/// Never destroyed: threads may outlive main().
ReaderProgram& fileReader();

/// Asks for the content of a text, such as a description, within limits that grow with its length. Throws what ReaderProgram::ask() does.
std::string askAboutText(const std::string& head, const std::string& text, const std::string& subject, const RunControl& control);

/// The kind that a question's head begins with; 0 for an empty head.
char kindOf(const std::string& head);

}  // namespace collision_hulls
