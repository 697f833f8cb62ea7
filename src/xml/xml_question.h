// XML that is parsed in a process of its own: both ends of the question.
#pragma once

#include <string>

#include "sandbox/serve.h"
#include "xml/xml_tree.h"

namespace collision_hulls {

/// What parseXml() does, in this process.
XmlNode decodeXml(const std::string& text, const std::string& label);

/// The worker's end.
std::string answerXmlQuestion(const Question& question);

/// The document in an answer. Throws ByteFault for what is none.
XmlNode xmlIn(const std::string& answer);

}  // namespace collision_hulls
