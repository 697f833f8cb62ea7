// The tree says what a value means, its escapes resolved; the spans say where it stands. Both list the elements in document order, so the
// nth of the one is the nth of the other.
#include "xml/xml_values.h"

#include "collision_hulls/error.h"
#include "xml/xml_spans.h"
#include "xml/xml_tree.h"

namespace collision_hulls {
namespace {

class ValueWriter {
 public:
  ValueWriter(const std::string& text, const std::string& name, const NewValue& new_value)
      : text_(text), name_(name), new_value_(new_value), spans_(scanXml(text).elements) {}

  /// The tree's elements in document order, each before its children.
  void visit(const XmlNode& node, const std::string& path) {
    if (next_ == spans_.size() || spans_[next_].name != node.name)
      throw Error(ErrorCode::kInternal, "new values of '" + name_ + "': <" + node.name + "> of line " + std::to_string(node.line) +
                                            " does not stand where it was found");
    const XmlElement& span = spans_[next_++];
    const auto value = node.attributes.find(name_);
    if (value != node.attributes.end()) write(span, path, value->second);
    for (const XmlNode& child : node.children) visit(child, path + "/" + child.name);
  }

  std::string result() const { return result_ + text_.substr(done_); }

 private:
  void write(const XmlElement& span, const std::string& path, const std::string& value) {
    const std::optional<XmlSpan> place = attributeValue(text_, span, name_);
    const std::optional<std::string> wanted = place ? new_value_(path, value) : std::nullopt;
    if (!wanted) return;
    result_ += text_.substr(done_, place->begin - done_) + xmlEscaped(*wanted);
    done_ = place->end;
  }

  const std::string &text_, &name_;
  const NewValue& new_value_;
  const std::vector<XmlElement> spans_;
  std::size_t next_ = 0;  // element
  std::string result_;    // of the text up to done_
  std::size_t done_ = 0;
};

}  // namespace

std::string withNewValues(const std::string& text, const std::string& label, const std::string& name, const NewValue& new_value,
                          const RunControl& control) {
  const XmlNode root = parseXml(text, label, control);
  ValueWriter writer(text, name, new_value);
  writer.visit(root, root.name);
  return writer.result();
}

}  // namespace collision_hulls
