// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/figures/figure_layout.h"

#include <algorithm>

#include "core/support/error.h"
#include "core/support/text.h"

namespace gonio::figures {

namespace {

constexpr double minCellWidth = 9;                     ///< mm
constexpr double gap = 1, rowGap = 1.5, inside = 0.6;  ///< mm: between columns, materials, parts of a cell
constexpr double lineSpacing = 1.2;                    ///< of a line, in sizes of the font
constexpr double ascent = 0.8;  ///< of the base line under the top of a line, in sizes of the font
constexpr double barHeight = 2, minBarWidth = 12, noteGap = 3, maxBarWidth = 30;  ///< mm
constexpr double oneColumnFont = 7, twoColumnsFont = 8;                           ///< pt
constexpr std::string_view referenceLabel = "Reference";

/// Parts between which a line may be broken; each has the space that follows it.
std::vector<std::string> partsOf(std::string_view text) {
  std::vector<std::string> parts(1);
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t length = firstCharacter(text.substr(at)).bytes;
    parts.back() += text.substr(at, length);
    if (length == 1 && (text[at] == ' ' || text[at] == '-' || text[at] == '_')) parts.emplace_back();
    at += length;
  }
  if (parts.back().empty()) parts.pop_back();
  return parts;
}

std::string trimmed(std::string text) {
  while (text.ends_with(' ')) text.pop_back();
  return text;
}

/// Builds the layout from the top to the bottom.
class LayoutBuilder {
 public:
  LayoutBuilder(const FigureDescription& description, const FigureTexts& texts, const TextWidth& width)
      : description_(description), texts_(texts), textWidth_(width) {}

  FigureLayout build();

 private:
  double lineHeight() const { return lineSpacing * fontHeight(); }
  double fontHeight() const { return layout_.fontSize * millimetresPerPoint; }
  std::size_t columnCount() const { return 1 + description_.representations.size(); }
  double columnLeft(std::size_t column) const { return gridLeft_ + double(column) * (cellWidth_ + gap); }
  std::vector<std::string> lines(const std::string& text, double maxWidth, bool bold) const {
    return brokenLines(text, maxWidth, layout_.fontSize, textWidth_, bold);
  }

  double tileWidth() const;
  double stackHeight() const;
  void measureColumns();
  LabelLayout label(const std::vector<std::string>& lines, double left, double width, double top) const;
  void placeTitle();
  void placeColumnLabels();
  void placeRow(std::size_t row);
  CellLayout cellAt(double left) const;
  LabelLayout rowLabel(std::size_t row) const;
  void placeLegend();

  const FigureDescription& description_;
  const FigureTexts& texts_;
  const TextWidth& textWidth_;
  FigureLayout layout_;
  double top_ = 0, gridLeft_ = 0, cellWidth_ = 0;
  std::vector<std::vector<std::string>> rowLines_;
};

/// Of the inset and of the error map; 0 without both.
double LayoutBuilder::tileWidth() const {
  const int tiles = int(description_.inset.has_value()) + int(description_.errorMaps);
  return tiles == 0 ? 0 : (cellWidth_ - inside * (tiles - 1)) / tiles;
}

/// Of a cell's pictures, without its numbers.
double LayoutBuilder::stackHeight() const { return cellWidth_ + (tileWidth() > 0 ? inside + tileWidth() : 0); }

/// The labels of the rows take as many lines at the left as the longest needs in the height of the pictures, which the
/// width of the cells, what the labels leave, determines: more lines, smaller cells.
void LayoutBuilder::measureColumns() {
  for (std::size_t count = 1;; ++count) {
    gridLeft_ = double(count) * lineHeight() + inside;
    cellWidth_ = (layout_.width - gridLeft_ - gap * double(columnCount() - 1)) / double(columnCount());
    if (cellWidth_ < minCellWidth)
      throw Error("found " + std::to_string(description_.representations.size()) + " representations in a figure " +
                  std::to_string(int(layout_.width)) + " mm wide, expected fewer: each image would be narrower than " +
                  std::to_string(int(minCellWidth)) + " mm");
    rowLines_.clear();
    std::size_t maxLines = 0;
    for (const std::string& name : texts_.rowNames) {
      rowLines_.push_back(lines(name, stackHeight(), true));
      maxLines = std::max(maxLines, rowLines_.back().size());
    }
    if (maxLines <= count) return;
  }
}

LabelLayout LayoutBuilder::label(const std::vector<std::string>& lines, double left, double width, double top) const {
  LabelLayout label{.lines = lines, .at = {}, .place = {left, top, width, double(lines.size()) * lineHeight()}};
  for (std::size_t i = 0; i < lines.size(); ++i)
    label.at.emplace_back(left + width / 2, top + double(i) * lineHeight() + ascent * fontHeight());
  return label;
}

void LayoutBuilder::placeTitle() {
  if (description_.title.empty()) return;
  layout_.title = label(lines(plainText(description_.title), layout_.width, true), 0, layout_.width, top_);
  top_ = layout_.title->place.bottom() + rowGap;
}

/// They end at one height, just above the pictures.
void LayoutBuilder::placeColumnLabels() {
  std::vector<std::vector<std::string>> all{lines(std::string(referenceLabel), cellWidth_, true)};
  for (const FigureRepresentation& one : description_.representations)
    all.push_back(lines(one.shownLabel(), cellWidth_, true));
  std::size_t maxLines = 0;
  for (const auto& lines : all) maxLines = std::max(maxLines, lines.size());
  for (std::size_t column = 0; column < all.size(); ++column)
    layout_.columnLabels.push_back(label(all[column], columnLeft(column), cellWidth_,
                                         top_ + double(maxLines - all[column].size()) * lineHeight()));
  top_ += double(maxLines) * lineHeight() + inside;
}

CellLayout LayoutBuilder::cellAt(double left) const {
  CellLayout cell{
      .picture = {left, top_, cellWidth_, cellWidth_}, .inset = {}, .errorMap = {}, .caption = {}, .numberLines = {}};
  const double tile = tileWidth(), tilesTop = top_ + cellWidth_ + inside;
  if (description_.inset) cell.inset = {left, tilesTop, tile, tile};
  if (description_.errorMaps) cell.errorMap = {left + cellWidth_ - tile, tilesTop, tile, tile};
  const double captionTop = top_ + stackHeight() + inside;
  cell.caption = {left, captionTop, cellWidth_, double(description_.numbers.size()) * lineHeight()};
  for (std::size_t i = 0; i < description_.numbers.size(); ++i)
    cell.numberLines.emplace_back(left + cellWidth_ / 2, captionTop + double(i) * lineHeight() + ascent * fontHeight());
  return cell;
}

LabelLayout LayoutBuilder::rowLabel(std::size_t row) const {
  const std::vector<std::string>& lines = rowLines_[row];
  const double width = double(lines.size()) * lineHeight(), left = gridLeft_ - inside - width;
  LabelLayout label{.lines = lines, .at = {}, .place = {left, top_, width, stackHeight()}};
  for (std::size_t i = 0; i < lines.size(); ++i)
    label.at.emplace_back(left + double(i) * lineHeight() + ascent * fontHeight(), top_ + stackHeight() / 2);
  return label;
}

void LayoutBuilder::placeRow(std::size_t row) {
  if (row > 0) top_ += rowGap;
  layout_.rowLabels.push_back(rowLabel(row));
  std::vector<CellLayout>& cells = layout_.cells.emplace_back();
  for (std::size_t column = 0; column < columnCount(); ++column) cells.push_back(cellAt(columnLeft(column)));
  top_ += stackHeight() + (description_.numbers.empty() ? 0 : inside + cells.front().caption.height);
}

void LayoutBuilder::placeLegend() {
  if (!description_.errorMaps && !description_.inset) return;
  top_ += rowGap;
  const auto widthOf = [&](const std::string& text) { return textWidth_(text, layout_.fontSize, false); };
  LegendLayout legend;
  double baseLine = top_ + ascent * fontHeight(), end = gridLeft_;
  int lines = 1;
  if (description_.errorMaps) {
    legend.zero = {gridLeft_ + widthOf("0"), baseLine};
    const double barLeft = legend.zero.x + inside, textWidth = widthOf(texts_.errorScale);
    const double noteWidth = description_.inset ? noteGap + widthOf(texts_.insetNote) : 0;
    const double barWidth =
        std::clamp(layout_.width - barLeft - inside - textWidth - noteWidth, minBarWidth, maxBarWidth);
    legend.bar = {barLeft, top_ + (lineHeight() - barHeight) / 2, barWidth, barHeight};
    legend.errorScale = {legend.bar->right() + inside, baseLine};
    end = legend.errorScale.x + textWidth + noteGap;
  }
  if (description_.inset && end + widthOf(texts_.insetNote) > layout_.width) {
    ++lines;
    baseLine += lineHeight();
  }
  legend.insetNote = {layout_.width, baseLine};
  legend.place = {0, top_, layout_.width, lines * lineHeight()};
  layout_.legend = legend;
  top_ += legend.place.height;
}

FigureLayout LayoutBuilder::build() {
  layout_.width = pageWidth(description_.width);
  layout_.fontSize = fontSizeOf(description_);
  measureColumns();
  top_ = inside;
  placeTitle();
  placeColumnLabels();
  for (std::size_t row = 0; row < texts_.rowNames.size(); ++row) placeRow(row);
  placeLegend();
  layout_.height = top_ + inside;
  return std::move(layout_);
}

}  // namespace

double pageWidth(FigureWidth width) { return width == FigureWidth::oneColumn ? oneColumnWidth : twoColumnsWidth; }

double fontSizeOf(const FigureDescription& description) {
  if (description.fontSize > 0) return description.fontSize;
  return description.width == FigureWidth::oneColumn ? oneColumnFont : twoColumnsFont;
}

std::vector<std::string> brokenLines(const std::string& text, double maxWidth, double size, const TextWidth& width,
                                     bool bold) {
  const auto fits = [&](const std::string& line) { return width(trimmed(line), size, bold) <= maxWidth; };
  std::vector<std::string> lines(1);
  for (const std::string& part : partsOf(text)) {
    if (fits(lines.back() + part)) {
      lines.back() += part;
      continue;
    }
    if (!lines.back().empty()) lines.emplace_back();
    for (std::size_t at = 0; at < part.size();) {
      const std::size_t length = firstCharacter(std::string_view(part).substr(at)).bytes;
      const std::string character = part.substr(at, length);
      if (!lines.back().empty() && !fits(lines.back() + character)) lines.emplace_back();
      lines.back() += character;
      at += length;
    }
  }
  for (std::string& line : lines) line = trimmed(line);
  return lines;
}

FigureLayout layOutFigure(const FigureDescription& description, const FigureTexts& texts, const TextWidth& width) {
  return LayoutBuilder(description, texts, width).build();
}

}  // namespace gonio::figures
