#include "drivers/scene/Expression.hpp"

#include "bem/base/Error.hpp"

#include <cmath>
#include <memory>
#include <muParser.h>
#include <mutex>
#include <vector>

namespace epafi::drivers {

namespace {

using bem::InputError;
using bem::message;

/// The position of a '=' that is not part of ==, <=, >= or !=; npos if there is none.
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

/// A muParser bound to variables of its own.
class Parser {
 public:
  Parser(const std::string& text, double t) {
    try {
      parser_.DefineVar("x", &point_.x);
      parser_.DefineVar("y", &point_.y);
      parser_.DefineConst("t", t);
      parser_.DefineConst("pi", std::acos(-1.0));
      parser_.SetExpr(text);
    } catch (const mu::Parser::exception_type& error) {
      throw InputError("is no expression in x, y and t: " + error.GetMsg());
    }
  }
  Parser(const Parser&) = delete;
  Parser& operator=(const Parser&) = delete;

  /// \throws InputError with muParser's complaint, or if there are several values.
  double operator()(bem::Vec2 point) {
    point_ = point;
    try {
      int values = 0;
      const double* value = parser_.Eval(values);
      if (values != 1)
        throw InputError(
            message("gives ", values, " values; a decimal point is written '.'"));
      return value[0];
    } catch (const mu::Parser::exception_type& error) {
      throw InputError("is no expression in x, y and t: " + error.GetMsg());
    }
  }

 private:
  bem::Vec2 point_;
  mu::Parser parser_;
};

/// One expression; as many parsers as there are threads that evaluate it at the same
/// time.
class Expression {
 public:
  Expression(std::string text, Place place, double t)
      : text_(std::move(text)), place_(std::move(place)), t_(t) {
    if (text_.find_first_not_of(" \t\r\n") == std::string::npos)
      fail("is empty");
    if (loneEqualSign(text_) != std::string::npos)
      fail("assigns with '='; nothing can be assigned, equality is '=='");
    evaluate({0, 0});  // for its syntax: the origin need not belong to the boundary
  }

  double operator()(bem::Vec2 point) const {
    const double value = evaluate(point);
    if (!std::isfinite(value))
      fail(message("is ", value, " at (x, y) = (", point.x, ", ", point.y, ")",
                   t_ == 1 ? "" : message(", t = ", t_),
                   "; one finite number is needed there"));
    return value;
  }

 private:
  double evaluate(bem::Vec2 point) const {
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
      return std::make_unique<Parser>(text_, t_);
    std::unique_ptr<Parser> parser = std::move(idle_.back());
    idle_.pop_back();
    return parser;
  }

  void giveBack(std::unique_ptr<Parser> parser) const {
    const std::lock_guard<std::mutex> lock(mutex_);
    idle_.push_back(std::move(parser));
  }

  [[noreturn]] void fail(const std::string& what) const {
    throw InputError(message(place_.file, ": ", place_.path, " = '", text_, "' ", what));
  }

  std::string text_;
  Place place_;
  double t_;
  mutable std::mutex mutex_;
  mutable std::vector<std::unique_ptr<Parser>> idle_;
};

}  // namespace

bem::Function makeExpression(const std::string& text, const Place& place, double t) {
  const auto expression = std::make_shared<const Expression>(text, place, t);
  return [expression](bem::Vec2 point) { return (*expression)(point); };
}

}  // namespace epafi::drivers
