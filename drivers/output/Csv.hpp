#pragma once

#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace epafi::drivers {

/// A number with 17 significant digits, enough to read back the same double.
std::string exactly(double value);

/// A number as a cell: integers as they are, others with `exactly`.
template <class Number>
std::string number(Number value) {
  if constexpr (std::is_integral_v<Number>)
    return std::to_string(value);
  else
    return exactly(value);
}

/// A row of a table: the names of its columns with the cells.
using CsvRow = std::vector<std::pair<std::string, std::string>>;

/// The first line of the table of a row, and the line of the row.
std::string headOf(const CsvRow& row);
std::string lineOf(const CsvRow& row);
/// Adds a row to a table, with a line of names before the first one.
void addRow(const CsvRow& row, std::string& table);
void append(CsvRow& row, const CsvRow& more, const std::string& prefix = "");

/// The cell of a column, and the number in it.  \pre there is a column of this name
std::string& cellOf(CsvRow& row, const std::string& column);
double valueOf(CsvRow row, const std::string& column);

/// The cells of a line of comma-separated values, with or without the line end.
std::vector<std::string> csvCells(const std::string& line);
/// The rows of a table.
std::vector<CsvRow> rowsOf(const std::string& table);

}  // namespace epafi::drivers
