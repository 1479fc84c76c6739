#include "drivers/scene/Expression.hpp"

#include "bem/base/Error.hpp"
#include "bem/base/Suggestion.hpp"

#include <Teuchos_ParameterList.hpp>

#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <cmath>
#include <memory>
#include <muParser.h>
#include <mutex>
#include <optional>
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

/// The names that an expression may use; each form includes those before it.
enum class Form { Constant, OfConstants, OfTime, OfPoint };

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

std::string toldOf(Form form, const Names& names) {
  const std::string text = form == Form::Constant      ? "constants before it"
                           : form == Form::OfConstants ? "constants"
                           : form == Form::OfTime      ? "t"
                           : names.normal              ? "x, y, t, nx and ny"
                                                       : "x, y and t";
  return text +
         namesIn(names.constants, form < Form::OfTime ? ": " : " and the constants ") +
         namesIn(names.tables, " and the tables ");
}

/// A muParser with its own variables.
class Parser {
 public:
  Parser(const std::string& text, const Names& names, Form form)
      : known_(toldOf(form, names)), normalAt_(names.normal) {
    try {
      parser_.DefineConst("pi", pi);
      for (const auto& [name, value] : names.constants)
        parser_.DefineConst(name, value);
      for (const auto& [name, table] : names.tables)
        parser_.DefineFunUserData(name, valueIn, const_cast<Interpolant*>(table.get()));
      if (form >= Form::OfTime)
        parser_.DefineConst("t", names.t);
      if (form == Form::OfPoint) {
        parser_.DefineVar("x", &point_.x);
        parser_.DefineVar("y", &point_.y);
      }
      if (normalAt_) {
        parser_.DefineVar("nx", &normal_.x);
        parser_.DefineVar("ny", &normal_.y);
      }
      parser_.SetExpr(text);
      if (text.find("nx") == std::string::npos && text.find("ny") == std::string::npos)
        normalAt_ = {};
    } catch (const mu::Parser::exception_type& error) {
      fail(error);
    }
  }
  /// Is the expression independent of the point?
  bool isConstant() const { return parser_.GetUsedVar().empty(); }

  Parser(const Parser&) = delete;
  Parser& operator=(const Parser&) = delete;

  /// \throws InputError with the message of muParser, or if there are several values.
  double operator()(bem::Vec2 point) {
    point_ = point;
    if (normalAt_)
      normal_ = normalAt_(point);
    try {
      int values = 0;
      const double* value = parser_.Eval(values);
      if (values != 1)
        throw InputError("gives ", values, " values; a decimal point is written '.'");
      return value[0];
    } catch (const mu::Parser::exception_type& error) {
      fail(error);
    }
  }

 private:
  [[noreturn]] void fail(const mu::Parser::exception_type& error) const {
    throw InputError("is no expression in " + known_ + ": " + error.GetMsg() +
                     meant(error));
  }

  std::string meant(const mu::Parser::exception_type& error) const {
    if (error.GetCode() != mu::ecUNASSIGNABLE_TOKEN)
      return "";
    const std::string rest = error.GetToken();  // includes the text behind it
    const std::string called = rest.substr(0, rest.find_first_not_of(letters));
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

  std::string known_;
  std::function<bem::Vec2(bem::Vec2)> normalAt_;
  bem::Vec2 point_;
  bem::Vec2 normal_;
  mu::Parser parser_;
};

/// An expression, with one parser per thread that evaluates it at the same time.
class Expression {
 public:
  Expression(std::string text, Place place, Names names, Form form)
      : text_(std::move(text)),
        place_(std::move(place)),
        names_(std::move(names)),
        form_(form) {
    if (text_.find_first_not_of(" \t\r\n") == std::string::npos)
      fail("is empty");
    if (loneEqualSign(text_) != std::string::npos)
      fail("assigns with '='; nothing can be assigned, equality is '=='");
    const double value =
        evaluate({0, 0});  // checks the syntax; the value at the origin may be undefined
    if (idle_.front()->isConstant())
      constant_ = value;
  }

  double operator()(bem::Vec2 point) const {
    double value = evaluate(point);
    if (std::isnan(value))
      value = std::abs(value);  // messages shall show nan, not -nan
    if (!std::isfinite(value) && form_ != Form::OfPoint)
      fail(message("is ", value, names_.t == 1 ? "" : message(" at t = ", names_.t),
                   "; one finite number is needed", ends()));
    if (!std::isfinite(value * value))
      fail(message("is ", value, " at (x, y) = (", point.x, ", ", point.y, ")",
                   names_.t == 1 ? "" : message(", t = ", names_.t),
                   std::isfinite(value) ? "; its square must be finite, too"
                                        : "; one finite number is needed there",
                   ends()));
    return value;
  }

 private:
  double evaluate(bem::Vec2 point) const {
    if (constant_)
      return *constant_;
    try {
      std::unique_ptr<Parser> parser = take();
      const double value = (*parser)(point);
      giveBack(std::move(parser));
      return value;
    } catch (const InputError& error) {
      fail(error.what());
    }
  }

  std::unique_ptr<Parser> take() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (idle_.empty())
      return std::make_unique<Parser>(text_, names_, form_);
    std::unique_ptr<Parser> parser = std::move(idle_.back());
    idle_.pop_back();
    return parser;
  }

  void giveBack(std::unique_ptr<Parser> parser) const {
    const std::lock_guard<std::mutex> lock(mutex_);
    idle_.push_back(std::move(parser));
  }

  /// The ranges of the tables that the text names: outside they have no value.
  std::string ends() const {
    std::string told;
    for (const auto& [name, table] : names_.tables)
      if (text_.find(name) != std::string::npos)
        told +=
            message("; ", name, " is given from ", table->low(), " to ", table->high());
    return told;
  }

  [[noreturn]] void fail(const std::string& what) const {
    throw InputError(place_.file, ": ", place_.path, " = '", text_, "' ", what);
  }

  std::string text_;
  Place place_;
  Names names_;
  Form form_;
  std::optional<double> constant_;
  mutable std::mutex mutex_;
  mutable std::vector<std::unique_ptr<Parser>> idle_;
};

/// \throws InputError for names that muParser does not accept as a new constant.
void checkName(const std::string& name, const Names& earlier) {
  if (name.find_first_not_of(letters) != std::string::npos ||
      std::string("0123456789_").find(name.front()) != std::string::npos)
    throw InputError(
        "is no name for expressions; letters, digits and _ make one, a letter first");
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
                             const Names& names) {
  const auto expression =
      std::make_shared<const Expression>(text, place, names, Form::OfPoint);
  return [expression](bem::Vec2 point) { return (*expression)(point); };
}

double evaluateAt(double t, const std::string& text, const Place& place,
                  const Names& names) {
  Names now = names;
  now.t = t;
  now.normal = {};  // the value is independent of the place, also on a boundary
  return Expression(text, place, now, Form::OfTime)({});
}

double evaluateConstant(const std::string& text, const Place& place, const Names& names) {
  return Expression(text, place, names, Form::OfConstants)({});
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
        Expression(list.get<std::string>(name), inner, names, Form::Constant)({});
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
