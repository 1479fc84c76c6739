#include "drivers/scene/Expression.hpp"

#include "bem/base/Error.hpp"
#include "bem/base/Suggestion.hpp"

#include <Teuchos_ParameterList.hpp>

#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <charconv>
#include <cmath>
#include <memory>
#include <muParser.h>
#include <mutex>
#include <optional>
#include <regex>
#include <vector>

namespace epafi::drivers {

namespace {

using bem::InputError;
using bem::message;

/// The position of an '=' that is not part of ==, <=, >= or !=; npos if there is none.
std::size_t loneEqualSign(const std::string& text) {
  for (std::size_t i = text.find('='); i != std::string::npos;
       i = text.find('=', i + 1)) {
    if (i + 1 < text.size() && text[i + 1] == '=')
      ++i;
    else if (i == 0 || std::string("<>!").find(text[i - 1]) == std::string::npos)
      return i;
  }
  return std::string::npos;
}

/// Characters of names in expressions.
constexpr const char* letters =
    "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ_0123456789";

constexpr double pi = boost::math::constants::pi<double>();

double valueIn(void* table, double at) {
  return (*static_cast<const Interpolant*>(table))(at);
}

template <class Map>
std::string namesIn(const Map& map, const char* before) {
  std::string text;
  for (const auto& item : map)
    text += (text.empty() ? before : ", ") + item.first;
  return text;
}

/// A text with its place and the names that it may use.
struct Source {
  std::string text;
  Place place;
  Names names;
  Form form;

  [[noreturn]] void fail(const std::string& what) const {
    throw InputError(place.file, ": ", place.path, " = '", text, "' ", what);
  }
  bool knowsPressure() const {
    return names.ofPressure && form == Form::OfPoint && isUnnamed("pressure");
  }
  /// Is x also called r, or y z?
  bool knows(const char* radiusOrAxis) const {
    return names.isAxisymmetric && form == Form::OfPoint && isUnnamed(radiusOrAxis);
  }
  bool isUnnamed(const char* name) const {
    return names.constants.count(name) == 0 && names.tables.count(name) == 0;
  }
  /// The names, for messages.
  std::string known() const {
    const std::string known = form == Form::Constant      ? "constants before it"
                              : form == Form::OfConstants ? "constants"
                              : form == Form::OfTime      ? "t"
                              : knowsPressure()           ? "x, y, t, nx, ny and pressure"
                              : names.onBoundary          ? "x, y, t, nx and ny"
                                                          : "x, y and t";
    return (knows("r") ? "r, " : "") + std::string(knows("z") ? "z, " : "") + known +
           namesIn(names.constants, form < Form::OfTime ? ": " : " and the constants ") +
           namesIn(names.tables, " and the tables ");
  }
  /// The ranges of the tables that the text names: outside they have no value.
  std::string ends() const {
    std::string told;
    for (const auto& [name, table] : names.tables)
      if (text.find(name) != std::string::npos)
        told +=
            message("; ", name, " is given from ", table->low(), " to ", table->high());
    return told;
  }
};

/// What a text of another language is here; empty where it is none.
std::string otherLanguage(const std::string& text) {
  const auto hasWord = [&](const std::string& word) {
    for (auto i = text.find(word); i != std::string::npos; i = text.find(word, i + 1)) {
      const auto isLetter = [&](std::size_t k) {
        return k < text.size() && std::string(letters).find(text[k]) != std::string::npos;
      };
      if (!isLetter(i - 1) && !isLetter(i + word.size()))
        return true;
    }
    return false;
  };
  if (hasWord("if") || hasWord("else"))
    return "; a choice is written 'condition ? value : other value'";
  for (const auto& [word, sign] : {std::pair("and", "&&"), std::pair("or", "||"),
                                   std::pair("AND", "&&"), std::pair("OR", "||")})
    if (hasWord(word))
      return message("; '", word, "' is written '", sign, "'");
  if (text.find("**") != std::string::npos || hasWord("pow"))
    return "; a power is written '^'";
  if (text.find("math.") != std::string::npos || text.find("np.") != std::string::npos)
    return "; functions stand without 'math.' or 'np.'";
  if (text.find('%') != std::string::npos)
    return "; per cent is a number, 0.3 for 30 %";
  if (text.find("\u00b0") != std::string::npos)
    return "; angles are in radian, 30*pi/180 for 30 degrees";
  if (text.find('"') != std::string::npos)
    return "; without quotes";
  static const std::regex exponent("[0-9.]+[dD][-+]?[0-9]+");
  if (std::regex_match(text, exponent))
    return "; an exponent of ten is written 'e', 2.1e5";
  static const std::regex separated("[0-9]+([_'][0-9]+)+");
  if (std::regex_match(text, separated))
    return "; digits are not separated";
  static const std::regex unit(
      "[-+]?[0-9][0-9.]*([eE][-+]?[0-9]+)? *[A-Za-z]+[0-9/^A-Za-z]*");
  if (std::regex_match(text, unit))
    return "; numbers have no units: those of a scene go together, such as N, mm and MPa";
  return "";
}

/// A muParser with its own variables.
class Parser {
 public:
  explicit Parser(const Source& source) : source_(source) {
    const Names& names = source.names;
    const bool atPoint = source.form == Form::OfPoint;
    try {
      parser_.DefineConst("pi", pi);
      for (const auto& [name, value] : names.constants)
        parser_.DefineConst(name, value);
      for (const auto& [name, table] : names.tables)
        parser_.DefineFunUserData(name, valueIn, const_cast<Interpolant*>(table.get()));
      if (source.form >= Form::OfTime)
        parser_.DefineConst("t", names.t);
      if (atPoint) {
        parser_.DefineVar("x", &point_.x);
        parser_.DefineVar("y", &point_.y);
      }
      if (source.knows("r"))
        parser_.DefineVar("r", &point_.x);
      if (source.knows("z"))
        parser_.DefineVar("z", &point_.y);
      if (atPoint && names.onBoundary) {
        parser_.DefineVar("nx", &point_.normal.x);
        parser_.DefineVar("ny", &point_.normal.y);
      }
      if (source.knowsPressure())
        parser_.DefineVar("pressure", &pressure_);
      parser_.SetExpr(source.text);
    } catch (const mu::Parser::exception_type& error) {
      fail(error);
    }
  }
  /// Is the expression independent of the point?
  bool isConstant() const { return parser_.GetUsedVar().empty(); }
  bool usesPressure() const { return parser_.GetUsedVar().count("pressure") != 0; }

  Parser(const Parser&) = delete;
  Parser& operator=(const Parser&) = delete;

  /// \throws InputError with the message of muParser, or if there are several values.
  double operator()(const bem::SurfacePoint& point, double pressure) {
    point_ = point;
    pressure_ = pressure;
    try {
      int values = 0;
      const double* value = parser_.Eval(values);
      if (values != 1)
        source_.fail(
            message("gives ", values, " values; a decimal point is written '.'"));
      return value[0];
    } catch (const mu::Parser::exception_type& error) {
      fail(error);
    }
  }

 private:
  [[noreturn]] void fail(const mu::Parser::exception_type& error) const {
    const std::string near = meant(error);
    source_.fail(
        "is not an expression in " + source_.known() + ": " + error.GetMsg() +
        (error.GetCode() == mu::ecUNEXPECTED_VAL || otherLanguage(source_.text).empty()
             ? near
             : otherLanguage(source_.text)));
  }

  std::string meant(const mu::Parser::exception_type& error) const {
    if (error.GetCode() == mu::ecUNEXPECTED_VAL ||
        error.GetCode() == mu::ecUNEXPECTED_VAR)
      return "; a product is written '*'";
    if (error.GetCode() != mu::ecUNASSIGNABLE_TOKEN)
      return "";
    const std::string rest = error.GetToken();  // includes the text behind it
    const std::string called = rest.substr(0, rest.find_first_not_of(letters));
    if (source_.form < Form::OfPoint && (called == "x" || called == "y"))
      return "; it is one number, which does not vary along x and y";
    if (called == "pressure")
      return "; the pressure of the contact is known in Friction->Coefficient of Law "
             "Coulomb alone";
    if (parser_.GetFunDef().count(called) != 0)
      return "; '(' follows the name of a function without a blank: " + called + "(x)";
    std::vector<std::string> names;
    const auto add = [&](const auto& map) {
      for (const auto& item : map)
        names.push_back(item.first);
    };
    add(parser_.GetConst());
    add(parser_.GetVar());
    add(parser_.GetFunDef());
    return bem::meant(called, names);
  }

  const Source& source_;
  bem::SurfacePoint point_;
  double pressure_ = 0;
  mu::Parser parser_;
};

/// Of a text that is one and nothing else, which needs no parser: a path reads all of them at each step.
std::optional<double> number(const std::string& text) {
  if (text.find_first_not_of("0123456789.eE+-") != std::string::npos)
    return std::nullopt;  // a name or an expression
  double value = 0;
  const char* end = text.data() + text.size();
  const auto [behind, error] = std::from_chars(text.data(), end, value);
  return error == std::errc() && behind == end ? std::optional(value) : std::nullopt;
}

/// An expression, with one parser per thread that evaluates it at the same time.
class Expression {
 public:
  explicit Expression(Source source) : source_(std::move(source)) {
    if (source_.text.find_first_not_of(" \t\r\n") == std::string::npos)
      source_.fail("is empty");
    if (loneEqualSign(source_.text) != std::string::npos)
      source_.fail("assigns with '='; nothing can be assigned, equality is '=='");
    constant_ = number(source_.text);
    if (constant_)
      return;
    const double value =
        evaluate({}, 0);  // checks the syntax; the value at the origin may be undefined
    if (idle_.front()->isConstant())
      constant_ = value;
    usesPressure_ = idle_.front()->usesPressure();
  }

  /// Its value, if this is the same at all points.
  std::optional<double> constant() const { return constant_; }

  bool usesPressure() const { return usesPressure_; }

  double operator()(const bem::SurfacePoint& point, double pressure = 0) const {
    const double t = source_.names.t;
    double value = evaluate(point, pressure);
    if (std::isnan(value))
      value = std::abs(value);  // messages shall show nan, not -nan
    if (!std::isfinite(value) && source_.form != Form::OfPoint)
      source_.fail(message("is ", value, t == 1 ? "" : message(" at t = ", t),
                           "; one finite number is needed", source_.ends()));
    if (!std::isfinite(value * value))
      source_.fail(message("is ", value, " at (x, y) = (", point.x, ", ", point.y, ")",
                           t == 1 ? "" : message(", t = ", t),
                           usesPressure_ ? message(", pressure = ", pressure) : "",
                           std::isfinite(value) ? "; its square must be finite, too"
                                                : "; one finite number is needed there",
                           source_.ends()));
    return value;
  }

 private:
  double evaluate(const bem::SurfacePoint& point, double pressure) const {
    if (constant_)
      return *constant_;
    std::unique_ptr<Parser> parser = take();
    const double value = (*parser)(point, pressure);
    const std::lock_guard<std::mutex> lock(mutex_);
    idle_.push_back(std::move(parser));
    return value;
  }

  std::unique_ptr<Parser> take() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (idle_.empty())
      return std::make_unique<Parser>(source_);
    std::unique_ptr<Parser> parser = std::move(idle_.back());
    idle_.pop_back();
    return parser;
  }

  Source source_;
  std::optional<double> constant_;
  bool usesPressure_ = false;
  mutable std::mutex mutex_;
  mutable std::vector<std::unique_ptr<Parser>> idle_;
};

/// \throws InputError for names that muParser does not accept as a new constant.
void checkName(const std::string& name, const Names& earlier) {
  if (name.find_first_not_of(letters) != std::string::npos ||
      std::string("0123456789_").find(name.front()) != std::string::npos)
    throw InputError(
        "is not a name for expressions; letters, digits and _ make one, a letter first");
  const mu::Parser parser;
  for (const char* known : {"x", "y", "t", "nx", "ny", "pi"})
    if (name == known)
      throw InputError("means something in expressions already");
  if (parser.GetFunDef().count(name) != 0)
    throw InputError("is a function of expressions already");
  if (earlier.tables.count(name) != 0)
    throw InputError("is the name of a table, too: Tables->" + name);
}

}  // namespace

bem::Function makeExpression(const std::string& text, const Place& place,
                             const Names& names, Form form) {
  const auto expression =
      std::make_shared<const Expression>(Source{text, place, names, form});
  return [expression](const bem::SurfacePoint& point) { return (*expression)(point); };
}

contact::PressureCoefficient makeExpressionOfPressure(const std::string& text,
                                                      const Place& place, Names names) {
  names.ofPressure = true;
  const auto expression =
      std::make_shared<const Expression>(Source{text, place, names, Form::OfPoint});
  if (!expression->usesPressure())
    return {};
  return [expression](const bem::SurfacePoint& point, double pressure) {
    return (*expression)(point, pressure);
  };
}

std::optional<double> constantIn(const std::string& text, const Place& place,
                                 const Names& names) {
  return Expression({text, place, names, Form::OfPoint}).constant();
}

namespace {

/// Calls read(name, place) for each item of a list that defines names for expressions.
template <class Read>
void forEachName(const Teuchos::ParameterList& list, const Place& place,
                 const Names& earlier, const Read& read) {
  for (const auto& item : list) {
    const Place inner{place.file, place.path + "->" + item.first};
    try {
      checkName(item.first, earlier);
      read(item.first, inner);
    } catch (const InputError& error) {
      const std::string what = error.what();
      throw InputError(what.rfind(place.file, 0) == 0 ? what : inner.path + ": " + what);
    }
  }
}

}  // namespace

Constants readConstants(const Teuchos::ParameterList& list, const Place& place,
                        const Tables& tables) {
  Names names;
  names.tables = tables;
  forEachName(list, place, names, [&](const std::string& name, const Place& inner) {
    names.constants[name] =
        makeExpression(list.get<std::string>(name), inner, names, Form::Constant)({});
  });
  return names.constants;
}

Tables readTables(Teuchos::ParameterList& list, const Place& place) {
  Names names;
  forEachName(list, place, names, [&](const std::string& name, const Place& inner) {
    names.tables[name] = readTable(list.sublist(name), inner.file);
  });
  return names.tables;
}

}  // namespace epafi::drivers
