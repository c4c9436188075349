// SPDX-License-Identifier: BSD-3-Clause
// Reads the small tables of Testing/Data: comma-separated values, comments after #, names in the
// first line.
#ifndef skyline_NumberTable_h
#define skyline_NumberTable_h

#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace skyline
{

using TableRow = std::map<std::string, std::string>;

inline std::vector<std::string> SplitLine(const std::string& line)
{
  std::vector<std::string> cells(1);
  bool quoted = false;
  for (const char c : line)
  {
    if (c == '"')
    {
      quoted = !quoted;
    }
    else if (c == ',' && !quoted)
    {
      cells.emplace_back();
    }
    else if (c != '\r')
    {
      cells.back() += c;
    }
  }
  return cells;
}

/// The rows of Testing/Data/<name>, each a map from column name to text.
inline std::vector<TableRow> ReadTable(const std::string& name)
{
  const std::string path = std::string(SKYLINE_TEST_DATA) + "/" + name;
  std::ifstream file(path);
  if (!file)
  {
    throw std::runtime_error("cannot open " + path);
  }
  std::vector<std::string> names;
  std::vector<TableRow> rows;
  for (std::string line; std::getline(file, line);)
  {
    if (line.empty() || line[0] == '#')
    {
      continue;
    }
    const std::vector<std::string> cells = SplitLine(line);
    if (names.empty())
    {
      names = cells;
      continue;
    }
    TableRow row;
    for (std::size_t i = 0; i < cells.size() && i < names.size(); ++i)
    {
      row[names[i]] = cells[i];
    }
    rows.push_back(row);
  }
  return rows;
}

inline double Number(const TableRow& row, const std::string& name)
{
  return std::stod(row.at(name));
}

} // namespace skyline

#endif
