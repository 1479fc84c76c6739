#include "drivers/output/Csv.hpp"

#include "drivers/scene/Text.hpp"

#include <algorithm>
#include <charconv>
#include <sstream>

namespace epafi::drivers {

namespace {

/// Appends a cell, quoted where RFC 4180 requires it: users choose names freely.
void add(const std::string& cell, std::string& line) {
  const auto isSpecial = [](char c) {
    return c == ',' || c == '"' || c == '\r' || c == '\n';
  };
  if (std::none_of(cell.begin(), cell.end(), isSpecial)) {
    line += cell;
    return;
  }
  line += '"';
  for (const char c : cell)
    line.append(c == '"' ? 2 : 1, c);
  line += '"';
}

std::string joined(const CsvRow& row, std::string CsvRow::value_type::*part) {
  std::string line;
  for (const auto& column : row) {
    if (&column != &row.front())
      line += ',';
    add(column.*part, line);
  }
  return line + '\n';
}

}  // namespace

std::string exactly(double value) {
  char text[32];  // as %.17g of printf, but much faster
  const auto end =
      std::to_chars(text, text + sizeof text, value, std::chars_format::general, 17);
  return {text, end.ptr};
}

std::string headOf(const CsvRow& row) { return joined(row, &CsvRow::value_type::first); }

std::string lineOf(const CsvRow& row) { return joined(row, &CsvRow::value_type::second); }

void addRow(const CsvRow& row, std::string& table) {
  if (table.empty())
    table = headOf(row);
  table += lineOf(row);
}

void append(CsvRow& row, const CsvRow& more, const std::string& prefix) {
  for (const auto& [name, cell] : more)
    row.emplace_back(prefix + name, cell);
}

std::string& cellOf(CsvRow& row, const std::string& column) {
  return std::find_if(row.begin(), row.end(),
                      [&](const auto& each) { return each.first == column; })
      ->second;
}

double valueOf(CsvRow row, const std::string& column) {
  return numberIn<double>(cellOf(row, column)).value();
}

std::vector<std::string> csvCells(const std::string& line) {
  std::vector<std::string> cells(1);
  bool inQuotes = false;
  for (std::size_t i = 0; i < line.size() && (inQuotes || line[i] != '\n'); ++i) {
    if (line[i] == ',' && !inQuotes)
      cells.emplace_back();
    else if (line[i] != '"')
      cells.back() += line[i];
    else if (inQuotes && line.compare(i, 2, "\"\"") == 0)
      cells.back() += line[i++];
    else
      inQuotes = !inQuotes;
  }
  return cells;
}

std::vector<CsvRow> rowsOf(const std::string& table) {
  std::istringstream lines(table);
  std::string line;
  std::getline(lines, line);
  const std::vector<std::string> names = csvCells(line);
  std::vector<CsvRow> rows;
  while (std::getline(lines, line)) {
    CsvRow& row = rows.emplace_back();
    for (const std::string& cell : csvCells(line))
      row.emplace_back(names.at(row.size()), cell);
  }
  return rows;
}

}  // namespace epafi::drivers
