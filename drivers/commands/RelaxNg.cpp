#include "bem/base/Error.hpp"
#include "drivers/commands/Commands.hpp"
#include "drivers/scene/SceneFile.hpp"

#include <cmath>
#include <sstream>

namespace epafi::drivers {

namespace {

bool standsForNames(const std::string& name) {
  return !name.empty() && name.front() == '<' && name.back() == '>';
}

/// The XML of one table of keys, list by list.
class Writer {
 public:
  Writer(const bem::SchemaRows& rows, std::ostream& out) : rows_(rows), out_(out) {}

  /// Everything below a list: its keys in any order.  RELAX NG cannot say "each at most
  /// once" of elements that differ in an attribute only.
  void content(const std::string& parent, const std::string& indent) {
    out_ << indent << "<zeroOrMore><choice>\n";
    for (const Parameter* row : childrenOf(rows_, parent))
      entry(*row, indent + "  ");
    out_ << indent << "</choice></zeroOrMore>\n";
  }

 private:
  void entry(const Parameter& row, const std::string& indent) {
    const bool list = row.kind == Kind::List || row.kind == Kind::Free;
    out_ << indent << "<element name=\"" << (list ? "ParameterList" : "Parameter")
         << "\">\n"
         << indent << "  <a:documentation>" << xmlText(row.meaning)
         << (row.unit.empty() ? "" : xmlText(" [" + row.unit + "]"))
         << "</a:documentation>\n"
         << indent << "  <attribute name=\"name\">" << nameOf(row) << "</attribute>\n"
         << indent << "  <ref name=\"marks\"/>\n";
    if (row.kind == Kind::Free)
      out_ << indent << "  <ref name=\"anything\"/>\n";
    else if (list)
      content(row.path, indent + "  ");
    else
      value(row, indent + "  ");
    out_ << indent << "</element>\n";
  }

  static std::string nameOf(const Parameter& row) {
    const std::string name = row.name();
    if (standsForNames(name))
      return "<text/>";
    const auto k = name.find("<k>");
    if (k == std::string::npos)
      return "<value>" + xmlText(name) + "</value>";
    return "<data type=\"string\"><param name=\"pattern\">" + name.substr(0, k) +
           "[1-9][0-9]*" + name.substr(k + 3) + "</param></data>";
  }

  void pair(const std::string& types, const std::string& values,
            const std::string& indent) {
    out_ << indent << "<attribute name=\"type\">" << types << "</attribute>\n"
         << indent << "<attribute name=\"value\">" << values << "</attribute>\n";
  }

  static std::string choice(const std::vector<std::string>& words) {
    std::string text = "<choice>";
    for (const std::string& word : words)
      text += "<value>" + xmlText(word) + "</value>";
    return text + "</choice>";
  }

  static std::string limits(const bem::Interval& interval) {
    std::string text;
    if (std::isfinite(interval.low))
      text += std::string("<param name=\"min") +
              (interval.lowOpen ? "Exclusive" : "Inclusive") + "\">" +
              bem::message(interval.low) + "</param>";
    if (std::isfinite(interval.high))
      text += std::string("<param name=\"max") +
              (interval.highOpen ? "Exclusive" : "Inclusive") + "\">" +
              bem::message(interval.high) + "</param>";
    return text;
  }

  void value(const Parameter& row, const std::string& indent) {
    const std::string any = "<text/>";
    const auto data = [&](const char* type) {
      return std::string("<data type=\"") + type + "\">" + limits(row.interval) +
             "</data>";
    };
    switch (row.kind) {
      case Kind::Real:
        return pair(choice({"double", "int"}), data("double"), indent);
      case Kind::Whole:
        return pair(choice({"int"}), data("integer"), indent);
      case Kind::Flag:
        return pair(choice({"bool"}), choice({"true", "false"}), indent);
      case Kind::Text:
        return pair(choice({"string"}), row.allowed.empty() ? any : choice(row.allowed),
                    indent);
      case Kind::Expression:
        return pair(choice({"string", "double", "int"}), any, indent);
      case Kind::Points:
        return pair(choice({"TwoDArray(double)", "TwoDArray(int)"}), any, indent);
      case Kind::Counts:
        return pair(choice({"Array(int)", "int"}), any, indent);
      case Kind::Reals:
        return pair(choice({"Array(double)", "Array(int)", "double", "int"}), any,
                    indent);
      default:  // arrays: their entries stand in one text
        return pair(choice({textOf(row.kind).type}), any, indent);
    }
  }

  const bem::SchemaRows& rows_;
  std::ostream& out_;
};

}  // namespace

std::string relaxNg(const std::vector<Grammar>& grammars) {
  std::ostringstream out;
  out << "<grammar xmlns=\"http://relaxng.org/ns/structure/1.0\"\n"
         "         xmlns:a=\"http://relaxng.org/ns/compatibility/annotations/1.0\"\n"
         "         datatypeLibrary=\"http://www.w3.org/2001/XMLSchema-datatypes\">\n"
         "  <a:documentation>Names, types, words and ranges; what is required, given "
         "twice, or depends on other keys, `epafi check` knows.</a:documentation>\n"
         "  <start><choice>\n";
  for (const Grammar& grammar : grammars)
    out << "    <ref name=\"" << grammar.name << "\"/>\n";
  out << "  </choice></start>\n";
  for (const Grammar& grammar : grammars) {
    out << "  <define name=\"" << grammar.name << "\">\n"
        << "    <element name=\"ParameterList\">\n"
           "      <optional><attribute name=\"name\"/></optional>\n"
           "      <ref name=\"marks\"/>\n";
    Writer(*grammar.rows, out).content("", "      ");
    out << "    </element>\n  </define>\n";
  }
  out << "  <define name=\"marks\">\n";
  for (const char* mark : {"id", "docString", "isDefault", "isUsed"})
    out << "    <optional><attribute name=\"" << mark << "\"/></optional>\n";
  out << "  </define>\n"
         "  <define name=\"anything\">\n"
         "    <zeroOrMore><choice>\n"
         "      <element name=\"Parameter\">\n"
         "        <attribute name=\"name\"/><attribute name=\"type\"/>"
         "<attribute name=\"value\"/>\n"
         "        <ref name=\"marks\"/>\n"
         "      </element>\n"
         "      <element name=\"ParameterList\">\n"
         "        <attribute name=\"name\"/><ref name=\"marks\"/>"
         "<ref name=\"anything\"/>\n"
         "      </element>\n"
         "    </choice></zeroOrMore>\n"
         "  </define>\n"
         "</grammar>\n";
  return out.str();
}

}  // namespace epafi::drivers
