#pragma once

#include "drivers/scene/Schema.hpp"

namespace epafi::drivers {

inline bem::Interval from(double low) {
  bem::Interval interval;
  interval.low = low;
  return interval;
}

inline bem::Interval above(double low) {
  bem::Interval interval = from(low);
  interval.lowOpen = true;
  return interval;
}

/// A row of a schema under construction: the constructor says what every parameter has,
/// the rest is named.
class Row {
 public:
  Row(const std::string& path, Kind kind, const std::string& meaning) {
    row_.path = path;
    row_.kind = kind;
    row_.meaning = meaning;
  }
  Row& unit(const std::string& unit) { return row_.unit = unit, *this; }
  Row& standard(const std::string& text) { return row_.standard = text, *this; }
  Row& required() { return row_.required = true, *this; }
  Row& only(const std::string& selector) { return row_.only = selector, *this; }
  Row& range(const bem::Interval& interval) { return row_.interval = interval, *this; }
  Row& allowed(const std::vector<std::string>& names) {
    return row_.allowed = names, *this;
  }

  Parameter done() const { return row_; }

 private:
  Parameter row_;
};

inline void add(std::vector<Parameter>& table, const std::vector<Row>& rows) {
  for (const Row& row : rows)
    table.push_back(row.done());
}

}  // namespace epafi::drivers
