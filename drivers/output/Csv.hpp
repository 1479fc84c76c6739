#pragma once

#include <string>
#include <type_traits>
#include <vector>

namespace epafi::drivers {

/// A number with all its digits: 17 significant ones.
std::string exactly(double value);

/// A number as a cell: whole ones as they are, others exactly.
template <class Number>
std::string number(Number value) {
  if constexpr (std::is_integral_v<Number>)
    return std::to_string(value);
  else
    return exactly(value);
}

/// A column of a table: its name, and what a row has there.
template <class Row>
struct Column {
  const char* name;
  std::string (*cell)(const Row& row);
};

/// What a chain of members leads to.
template <class Row, auto... members>
std::string cellOf(const Row& row) {
  return number((row.*....*members));
}

template <class Row, std::size_t count>
void addNames(const Column<Row> (&columns)[count], const std::string& prefix,
              std::vector<std::string>& names) {
  for (const Column<Row>& column : columns)
    names.push_back(prefix + column.name);
}

template <class Row, std::size_t count>
void addCells(const Column<Row> (&columns)[count], const Row& row,
              std::vector<std::string>& cells) {
  for (const Column<Row>& column : columns)
    cells.push_back(column.cell(row));
}

/// One line of comma-separated values.
std::string csvLine(const std::vector<std::string>& cells);

/// A table of columns alone: its first line, and that of a row.
template <class Row, std::size_t count>
std::string csvHead(const Column<Row> (&columns)[count]) {
  std::vector<std::string> names;
  addNames(columns, "", names);
  return csvLine(names);
}

template <class Row, std::size_t count>
std::string csvRow(const Column<Row> (&columns)[count], const Row& row) {
  std::vector<std::string> cells;
  addCells(columns, row, cells);
  return csvLine(cells);
}

/// The cells of such a line, with or without its end.
std::vector<std::string> csvCells(const std::string& line);

}  // namespace epafi::drivers
