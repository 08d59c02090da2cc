// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/figures/figure_tables.h"

#include <cmath>

#include "core/figures/draw_figure.h"
#include "core/figures/figure_description.h"
#include "core/rendering/render_picture.h"
#include "core/support/text.h"

namespace gonio::figures {

namespace {

/// "$1.25\times10^{-5}$" of "1.25e-05".
std::string latexNumber(const FigureNumber& number, double value) {
  if (std::isinf(value)) return value > 0 ? "$\\infty$" : "$-\\infty$";
  if (std::isnan(value)) return "--";
  const std::string text = tableText(number, value);
  const std::size_t exponent = text.find('e');
  if (exponent == std::string::npos) return value < 0 ? "$" + text + "$" : text;
  return "$" + text.substr(0, exponent) + "\\times10^{" + std::to_string(std::stoi(text.substr(exponent + 1))) + "}$";
}

std::string latexRow(const FigureDescription& description, const FigureRow& row, std::size_t cell) {
  std::string line = " & " + latexText(description.representations[cell].shownLabel());
  for (std::size_t i = 0; i < description.numbers.size(); ++i) {
    const std::string& id = description.numbers[i];
    const std::string text = latexNumber(figureNumber(id), row.cells[cell]->value(id));
    line += " & " + (isBest(description, row, cell, i) ? "{\\boldmath\\textbf{" + text + "}}" : text);
  }
  return line + " \\\\\n";
}

}  // namespace

std::string figurePicturesText(const FigurePictures& pictures) {
  const std::string scene = pictures.scene.empty() ? rendering::comparisonSceneName : pictures.scene;
  const std::string size = std::to_string(pictures.size);
  return scene + (pictures.environment.empty() ? "" : ", environment " + pictures.environment) + ", " + size + " x " +
         size + ", " + std::to_string(pictures.samples) + " samples";
}

io::CsvTable figureCsv(const FigureDescription& description, const FigureMeasurement& measurement) {
  io::CsvTable table{.comments = {"pictures: " + figurePicturesText(description.pictures)}, .columns = {}};
  if (!description.title.empty()) table.comments.insert(table.comments.begin(), description.title);
  io::CsvColumn materials{"material", {}}, ids{"representation", {}}, labels{"label", {}}, budgets{"budget", {}};
  std::vector<io::CsvColumn> numbers;
  for (const std::string& id : description.numbers) numbers.push_back({figureNumber(id).title(), {}});
  for (std::size_t row = 0; row < measurement.rows.size(); ++row)
    for (std::size_t cell = 0; cell < measurement.rows[row].cells.size(); ++cell) {
      const FigureRepresentation& shown = description.representations[cell];
      materials.texts.push_back(rowLabel(description, measurement, row));
      ids.texts.push_back(shown.representation.id());
      labels.texts.push_back(shown.shownLabel());
      budgets.values.push_back(shown.representation.budget);
      for (std::size_t i = 0; i < numbers.size(); ++i)
        numbers[i].values.push_back(measurement.rows[row].cells[cell]->value(description.numbers[i]));
    }
  table.columns = {materials, ids, labels, budgets};
  for (io::CsvColumn& column : numbers) table.columns.push_back(std::move(column));
  return table;
}

std::string figureLatex(const FigureDescription& description, const FigureMeasurement& measurement) {
  std::string text = "% Pictures: " + plainText(figurePicturesText(description.pictures)) +
                     "\n% Needs \\usepackage{booktabs}\n\\begin{tabular}{ll" +
                     std::string(description.numbers.size(), 'r') + "}\n\\toprule\nMaterial & Representation";
  for (const std::string& id : description.numbers) text += " & " + latexText(figureNumber(id).title());
  text += " \\\\\n";
  for (std::size_t row = 0; row < measurement.rows.size(); ++row) {
    text += "\\midrule\n";
    for (std::size_t cell = 0; cell < measurement.rows[row].cells.size(); ++cell)
      text += (cell == 0 ? latexText(rowLabel(description, measurement, row)) : "") +
              latexRow(description, measurement.rows[row], cell);
  }
  return text + "\\bottomrule\n\\end{tabular}\n";
}

std::string latexText(std::string_view text) {
  std::string result;
  for (const char c : plainText(text)) switch (c) {
      case '\\':
        result += "\\textbackslash{}";
        break;
      case '~':
        result += "\\textasciitilde{}";
        break;
      case '^':
        result += "\\textasciicircum{}";
        break;
      case '<':
        result += "\\textless{}";
        break;
      case '>':
        result += "\\textgreater{}";
        break;
      case '|':
        result += "\\textbar{}";
        break;
      case '"':
      case '`':
        result += "\\symbol{" + std::to_string(int(c)) + "}";
        break;
      case '\'':
      case ',':
      case '-':
        result += (result.ends_with(c) ? "{}" : "") + std::string(1, c);
        break;
      case '[':
        result += result.find_first_not_of(' ') == std::string::npos ? "{[}" : "[";
        break;
      case '&':
      case '%':
      case '$':
      case '#':
      case '_':
      case '{':
      case '}':
        result += '\\';
        [[fallthrough]];
      default:
        result += c;
    }
  return result;
}

}  // namespace gonio::figures
