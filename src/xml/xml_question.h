// XML that is parsed in a process of its own: both ends of the question.
#pragma once

#include <functional>
#include <string>

#include "sandbox/serve.h"
#include "xml/xml_tree.h"

namespace collision_hulls {

/// Takes a text and its label: decodeXml() of the room decode.
using XmlDecoder = std::function<XmlNode(const std::string&, const std::string&)>;

/// The worker's end.
std::string answerXmlQuestion(const Question& question, const XmlDecoder& decode);

/// The document in an answer. Throws ByteFault for what is none.
XmlNode xmlIn(const std::string& answer);

}  // namespace collision_hulls
