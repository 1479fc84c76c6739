#include "drivers/output/Csv.hpp"

#include <cassert>
#include <charconv>

namespace epafi::drivers {

namespace {

/// Quoted where RFC 4180 wants it: boundary names are the user's.
std::string quoted(const std::string& cell) {
  if (cell.find_first_of(",\"\r\n") == std::string::npos)
    return cell;
  std::string result = "\"";
  for (const char c : cell)
    result += c == '"' ? std::string("\"\"") : std::string(1, c);
  return result + "\"";
}

}  // namespace

std::string exactly(double value) {
  char text[32];  // as printf's %.17g, in a fraction of its time
  const auto end =
      std::to_chars(text, text + sizeof text, value, std::chars_format::general, 17);
  return {text, end.ptr};
}

std::string csvLine(const std::vector<std::string>& cells) {
  std::string line;
  for (std::size_t i = 0; i < cells.size(); ++i)
    line += (i == 0 ? "" : ",") + quoted(cells[i]);
  return line + '\n';
}

Csv::Csv(const std::vector<std::string>& columns)
    : columns_(columns.size()), text_(csvLine(columns)) {}

void Csv::row(const std::vector<std::string>& cells) {
  assert(cells.size() == columns_);
  text_ += csvLine(cells);
}

}  // namespace epafi::drivers
