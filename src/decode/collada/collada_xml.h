// Elements of a Collada document: attributes, numbers, and errors that name the line.
#pragma once

#include <tinyxml2.h>

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace collision_hulls {

using ColladaElement = tinyxml2::XMLElement;

/// Parses a document and returns its root, <COLLADA>. Throws kNotAMesh for what is not well-formed, for declarations such as DOCTYPE, whose
/// entities readers differ on, and for elements that nest too deeply; kTooLarge for too many of them.
const ColladaElement& parseCollada(const std::string& bytes, const std::string& path, tinyxml2::XMLDocument* document);

/// Throws kNotAMesh for an element.
[[noreturn]] void failElement(const std::string& path, const ColladaElement& element, const std::string& reason);

bool isNamed(const ColladaElement& element, std::string_view name);

/// The value of an attribute; empty if it is missing.
std::string_view attributeOf(const ColladaElement& element, const char* name);

/// An attribute that counts things, from 0 to `most`; `otherwise` if it is missing.
std::size_t countOf(const std::string& path, const ColladaElement& element, const char* name, std::size_t otherwise, std::size_t most);

/// The id that an attribute refers to, as in source="#id"; throws kNotAMesh for references to other files.
std::string_view targetOf(const std::string& path, const ColladaElement& element, const char* attribute);

/// The text of an element that holds nothing else; throws kNotAMesh if it does.
std::string_view textOf(const std::string& path, const ColladaElement& element);

/// The children with this name; all if it is null.
std::vector<const ColladaElement*> childrenOf(const ColladaElement& element, const char* name = nullptr);

/// The only child with this name, or null; throws kNotAMesh if there are several.
const ColladaElement* onlyChild(const std::string& path, const ColladaElement& element, const char* name);

}  // namespace collision_hulls
