// XML text to the tree of a deck: the parameter lists of Teuchos, which decks of Peridigm may be written in.
#include <tinyxml2.h>

#include <algorithm>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include "deck_data.hpp"
#include "deck_parameters.hpp"

namespace pd {

namespace {

using Data = DeckNode::Data;
using tinyxml2::XMLAttribute;
using tinyxml2::XMLElement;
using tinyxml2::XMLNode;

const std::vector<std::string> scalarTypes{"int", "double", "bool", "string"};

std::string withoutBlanks(const std::string& text) {
  const char* blanks = " \t\r\n";
  const std::size_t first = text.find_first_not_of(blanks);
  return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

/// The name that we use for a type of Teuchos; empty where there is none.
std::string plainType(const std::string& type) {
  if (type == "float") return "double";
  if (type == "short" || type == "long" || type == "long long") return "int";
  return std::find(scalarTypes.begin(), scalarTypes.end(), type) != scalarTypes.end() ? type : "";
}

class XmlReader {
 public:
  explicit XmlReader(const std::string& source) : source_(std::make_shared<const std::string>(source)) {}

  std::shared_ptr<Data> read(const std::string& text) {
    tinyxml2::XMLDocument document;
    document.Parse(text.data(), text.size());
    if (document.Error()) {
      mistakes_.add(place(document.ErrorLineNum()), "XML syntax: " + syntaxProblem(document));
      mistakes_.report();
    }
    const XMLElement* top = document.RootElement();
    if (top == nullptr) return nullptr;
    if (std::string(top->Name()) != "ParameterList")
      mistakes_.add(place(top->GetLineNum()), std::string("a deck in XML is one <ParameterList>, not <") + top->Name() +
                                                  ">; put its sections in there");
    auto root = make(Data::Kind::Map, top->GetLineNum(), top->GetLineNum());
    entries(*top, *root);
    if (const XMLElement* second = top->NextSiblingElement())
      mistakes_.add(place(second->GetLineNum()), "a second root element; a deck in XML is one <ParameterList>");
    mistakes_.report();
    return root;
  }

 private:
  static std::string syntaxProblem(const tinyxml2::XMLDocument& document) {
    switch (document.ErrorID()) {
      case tinyxml2::XML_ERROR_MISMATCHED_ELEMENT:
        return "a closing tag does not belong to the element that is open; look for a missing \"/>\" or </...>";
      case tinyxml2::XML_ERROR_PARSING_ATTRIBUTE:
        return "attributes are written as name=\"value\" with blanks in between; look at the quotes";
      case tinyxml2::XML_ERROR_PARSING_COMMENT:
        return "a comment is not closed; it ends with -->";
      case tinyxml2::XML_ERROR_PARSING_ELEMENT:
        return "an element is not closed, or \"<\" stands alone; elements end with \"/>\" or </...>";
      case tinyxml2::XML_ERROR_EMPTY_DOCUMENT:
        return "there is no element in it; a deck in XML is one <ParameterList>";
      case tinyxml2::XML_ELEMENT_DEPTH_EXCEEDED:
        return "lists are nested too deeply";
      default:
        return std::string(document.ErrorName()) + "; look at the tags and quotes here and just above";
    }
  }

  std::string place(int line) const { return *source_ + (line > 0 ? ":" + std::to_string(line) : ""); }

  std::shared_ptr<Data> make(Data::Kind kind, int line, int keyLine) const {
    auto node = std::make_shared<Data>();
    node->kind = kind;
    node->source = source_;
    node->line = line;
    node->keyLine = keyLine;
    return node;
  }

  void entries(const XMLElement& list, Data& into) {
    for (const XMLNode* child = list.FirstChild(); child != nullptr; child = child->NextSibling()) {
      if (const XMLElement* element = child->ToElement())
        entry(*element, into);
      else if (const tinyxml2::XMLText* text = child->ToText())
        mistakes_.add(place(text->GetLineNum()),
                      "\"" + withoutBlanks(text->Value()).substr(0, 40) +
                          "\" stands outside of elements; a comment is written <!-- ... -->");
    }
  }

  void entry(const XMLElement& element, Data& into) {
    const std::string kind = element.Name();
    const int line = element.GetLineNum();
    if (kind != "Parameter" && kind != "ParameterList") {
      mistakes_.add(place(line), "unknown element <" + kind + ">" + didYouMean(kind, {"Parameter", "ParameterList"}) +
                                     "; known here: <Parameter>, <ParameterList>");
      return;
    }
    const XMLAttribute* name = element.FindAttribute("name");
    if (name == nullptr || withoutBlanks(name->Value()).empty()) {
      mistakes_.add(place(line), "this <" + kind + "> has no name; write <" + kind + " name=\"...\">");
      return;
    }
    checkAttributes(element, kind);
    if (const Data* earlier = into.entry(name->Value())) {
      mistakes_.add(place(line), std::string("\"") + name->Value() +
                                     "\" is given twice in the same section (first in line " +
                                     std::to_string(earlier->keyLine) + "); remove one of them");
      return;
    }
    std::shared_ptr<Data> node;
    if (kind == "ParameterList") {
      node = make(Data::Kind::Map, line, line);
      entries(element, *node);
    } else {
      node = parameter(element, name->Value());
    }
    if (node) into.entries.emplace_back(name->Value(), node);
  }

  void checkAttributes(const XMLElement& element, const std::string& kind) {
    static const std::vector<std::string> forAll{"name", "id", "docString", "isDefault", "isUsed"};
    std::vector<std::string> known = forAll;
    if (kind == "Parameter") known.insert(known.end(), {"type", "value"});
    for (const XMLAttribute* attribute = element.FirstAttribute(); attribute != nullptr; attribute = attribute->Next())
      if (std::find(known.begin(), known.end(), attribute->Name()) == known.end())
        mistakes_.add(place(attribute->GetLineNum()), std::string("unknown attribute \"") + attribute->Name() +
                                                          "\" of <" + kind + ">" +
                                                          didYouMean(attribute->Name(), known));
  }

  std::shared_ptr<Data> parameter(const XMLElement& element, const std::string& name) {
    const XMLAttribute *type = element.FindAttribute("type"), *value = element.FindAttribute("value");
    for (const auto& [attribute, key] : {std::make_pair(type, "type"), std::make_pair(value, "value")})
      if (attribute == nullptr)
        mistakes_.add(place(element.GetLineNum()),
                      "parameter \"" + name + "\" has no " + key + "; write <Parameter name=\"" + name +
                          "\" type=\"...\" value=\"...\"/> with one of the types " + quotedList(scalarTypes));
    if (type == nullptr || value == nullptr) return nullptr;
    const std::string typeName = withoutBlanks(type->Value());
    const bool isArray = typeName.rfind("Array(", 0) == 0 && typeName.back() == ')';
    const std::string plain = plainType(isArray ? typeName.substr(6, typeName.size() - 7) : typeName);
    if (plain.empty()) {
      mistakes_.add(place(type->GetLineNum()), "parameter \"" + name + "\": unknown type \"" + typeName + "\"" +
                                                   didYouMean(typeName, scalarTypes) + "; known here: " +
                                                   quotedList(scalarTypes) + ", and \"Array(int)\" and so on");
      return nullptr;
    }
    const int line = value->GetLineNum(), keyLine = element.GetLineNum();
    if (!isArray) return scalar(name, plain, value->Value(), line, keyLine);
    auto list = make(Data::Kind::Sequence, line, keyLine);
    for (const std::string& item : itemsOf(value->Value(), name, line))
      if (auto node = scalar(name, plain, item, line, keyLine)) list->items.push_back(node);
    return list;
  }

  std::shared_ptr<Data> scalar(const std::string& name, const std::string& type, const std::string& given, int line,
                               int keyLine) {
    auto node = make(Data::Kind::Scalar, line, keyLine);
    node->xmlType = type;
    node->isQuoted = type == "string";
    node->scalar = type == "string" ? given : withoutBlanks(given);
    if (type == "bool" && (node->scalar == "1" || node->scalar == "0"))
      node->scalar = node->scalar == "1" ? "true" : "false";
    const bool hasForm = type == "string" || (type == "int" && parseInteger(node->scalar)) ||
                         (type == "double" && parseReal(node->scalar)) || (type == "bool" && parseFlag(node->scalar));
    if (hasForm) return node;
    mistakes_.add(place(line),
                  "parameter \"" + name + "\": \"" + given + "\" is no value of type \"" + type + "\"" +
                      (type == "int" && parseReal(node->scalar) ? " (write it without a point, or type=\"double\")"
                       : type == "bool"                         ? " (true or false)"
                                                                : ""));
    return nullptr;
  }

  /// "{1.0, 2.0}" as its items.
  std::vector<std::string> itemsOf(const std::string& given, const std::string& name, int line) {
    const std::string text = withoutBlanks(given);
    if (text.size() < 2 || text.front() != '{' || text.back() != '}') {
      mistakes_.add(place(line), "parameter \"" + name + "\": the value of an array is written \"{..., ...}\"");
      return {};
    }
    std::vector<std::string> items;
    std::istringstream stream(text.substr(1, text.size() - 2));
    for (std::string item; std::getline(stream, item, ',');) items.push_back(withoutBlanks(item));
    return items;
  }

  std::shared_ptr<const std::string> source_;
  Mistakes mistakes_;
};

}  // namespace

std::shared_ptr<Data> readXml(const std::string& text, const std::string& source) {
  return XmlReader(source).read(text);
}

}  // namespace pd
