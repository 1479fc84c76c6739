#include "drivers/output/Csv.hpp"

#include <algorithm>
#include <charconv>

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

}  // namespace

std::string exactly(double value) {
  char text[32];  // as %.17g of printf, but much faster
  const auto end =
      std::to_chars(text, text + sizeof text, value, std::chars_format::general, 17);
  return {text, end.ptr};
}

std::string csvLine(const std::vector<std::string>& cells) {
  std::string line;
  for (const std::string& cell : cells) {
    if (&cell != &cells.front())
      line += ',';
    add(cell, line);
  }
  return line + '\n';
}

void addRow(const CsvRow& row, std::string& table) {
  const bool isFirst = table.empty();
  for (const auto& [name, cell] : row)
    if (isFirst)
      table += (table.empty() ? "" : ",") + std::string(name);
  for (const auto& [name, cell] : row) {
    table += &cell == &row.front().second ? (isFirst ? "\n" : "") : ",";
    add(cell, table);
  }
  table += '\n';
}

void append(CsvRow& row, const CsvRow& more) {
  row.insert(row.end(), more.begin(), more.end());
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

}  // namespace epafi::drivers
