// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/reproduction/charts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "core/figures/draw_figure.h"
#include "core/figures/figure_formats.h"
#include "core/plots/value_scale.h"
#include "core/rendering/error_maps.h"

namespace gonio::reproduction {

namespace {

using namespace figures;

constexpr double pageFontSize = 7, titleFontSize = 8;  // pt
constexpr double pageLine = 3.1, pageMargin = 2;       // mm
constexpr const char* pageFont = "Helvetica";

/// Colours that the colour-blind can distinguish (Okabe and Ito 2008, "Color Universal Design").
constexpr std::array seriesColours{"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                   "#e69f00", "#56b4e9", "#000000", "#999933"};
constexpr std::array seriesMarkers{plots::Marker::square,       plots::Marker::triangle, plots::Marker::diamond,
                                   plots::Marker::triangleDown, plots::Marker::cross,    plots::Marker::pentagon,
                                   plots::Marker::star,         plots::Marker::saltire};

FigureDrawing newPage(const std::string& title) {
  FigureDrawing page{.width = twoColumnsWidth, .height = 0, .font = pageFont, .title = title, .items = {}};
  page.items.emplace_back(TextItem{{pageMargin, pageMargin + pageLine}, title, titleFontSize, TextAnchor::start, true});
  return page;
}

constexpr double contentTop = 2 * pageMargin + pageLine + 3;

std::string tickText(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", value);
  return text;
}

/// Draws one chart inside a rectangle of the page.
class ChartPainter {
 public:
  ChartPainter(const Chart& chart, const PageRectangle& place, FigureDrawing& page)
      : chart_(chart), page_(page), width_(cairoTextWidth(pageFont)) {
    area_ = {place.x + 14, place.y + 5, place.width - 18, place.height - 15 - legendHeight(place.width - 18)};
    x_ = scaleOf(chart.xRange, chart.logX, 0);
    y_ = scaleOf(chart.yRange, chart.logY, 1);
    if (chart.isDisk) fitDisk(place);
  }

  void paint() {
    text({area_.x + area_.width / 2, area_.y - 1.5}, chart_.title, TextAnchor::middle, true);
    if (chart_.raster) page_.items.emplace_back(PictureItem{area_, *chart_.raster, true});
    if (!chart_.isDisk) paintAxes();
    for (std::size_t i = 0; i < chart_.series.size(); ++i) paintSeries(i);
    paintLegend();
  }

 private:
  plots::ValueScale scaleOf(const std::optional<std::array<double, 2>>& range, bool logarithmic, int axis) const {
    if (range) return {logarithmic, (*range)[0], (*range)[1]};
    std::vector<double> values;
    for (const ChartSeries& series : chart_.series)
      for (const glm::dvec2& point : series.points) values.push_back(point[axis]);
    return plots::scaleFor(values, logarithmic);
  }

  void fitDisk(const PageRectangle& place) {
    const double spanX = x_.max - x_.min, spanY = y_.max - y_.min;
    const double scale = std::min((place.width - 4) / spanX, (place.height - 8) / spanY);
    area_ = {place.x + (place.width - scale * spanX) / 2, place.y + 5, scale * spanX, scale * spanY};
  }

  void text(const glm::dvec2& at, const std::string& words, TextAnchor anchor, bool bold = false, bool upward = false) {
    if (!words.empty()) page_.items.emplace_back(TextItem{at, words, pageFontSize, anchor, bold, upward});
  }
  void line(std::vector<glm::dvec2> points, const char* colour, double width) {
    page_.items.emplace_back(LineItem{std::move(points), colour, width});
  }
  glm::dvec2 place(const glm::dvec2& value) const {
    return {area_.x + area_.width * x_.fraction(value.x), area_.bottom() - area_.height * y_.fraction(value.y)};
  }

  static std::vector<double> ticksOf(const plots::ValueScale& scale) {
    std::vector<double> ticks = plots::scaleTicks(scale);
    if (!scale.logarithmic && scale.min <= 0 && scale.max >= 0) ticks.push_back(0);
    return ticks;
  }

  void paintAxes() {
    constexpr const char* grid = "#dddddd";
    for (const double tick : ticksOf(x_)) {
      const double x = area_.x + area_.width * x_.fraction(tick);
      if (!chart_.raster) line({{x, area_.y}, {x, area_.bottom()}}, grid, 0.1);
      text({x, area_.bottom() + pageLine}, tickText(tick), TextAnchor::middle);
    }
    for (const double tick : ticksOf(y_)) {
      const double y = area_.bottom() - area_.height * y_.fraction(tick);
      if (!chart_.raster) line({{area_.x, y}, {area_.right(), y}}, grid, 0.1);
      text({area_.x - 1, y + 0.9}, tickText(tick), TextAnchor::end);
    }
    page_.items.emplace_back(FrameItem{area_, "#222222", 0.15});
    text({area_.x + area_.width / 2, area_.bottom() + 2.3 * pageLine}, chart_.xTitle, TextAnchor::middle);
    text({area_.x - 9.5, area_.y + area_.height / 2}, chart_.yTitle, TextAnchor::middle, false, true);
  }

  std::string colourOf(std::size_t series) const {
    const std::string& own = chart_.series[series].colour;
    return own.empty() ? seriesColours[series % seriesColours.size()] : own;
  }

  void paintMarker(std::size_t series, const glm::dvec2& at) {
    const plots::Marker own = chart_.series[series].marker.value_or(seriesMarkers[series % seriesMarkers.size()]);
    std::vector<glm::dvec2> outline = plots::markerOutline(own, 0.75);
    for (glm::dvec2& corner : outline) corner += at;
    outline.push_back(outline.front());
    page_.items.emplace_back(LineItem{std::move(outline), colourOf(series), 0.25});
  }

  void paintSeries(std::size_t index) {
    const ChartSeries& series = chart_.series[index];
    std::vector<glm::dvec2> places;
    for (const glm::dvec2& point : series.points) {
      const bool isShown = std::isfinite(point.x) && std::isfinite(point.y) && (!chart_.logX || point.x > 0) &&
                           (!chart_.logY || point.y > 0);
      places.push_back(isShown ? place(point) : glm::dvec2(std::nan("")));
    }
    const double dash = series.isDashed ? 1.2 : 0;
    if (series.isLine)
      for (auto& part : plots::clipPolyline(places, {area_.x, area_.y}, {area_.right(), area_.bottom()}))
        page_.items.emplace_back(LineItem{std::move(part), colourOf(index), chart_.isDisk ? 0.15 : 0.3, dash});
    if (series.hasMarkers)
      for (const glm::dvec2& at : places)
        if (at.x >= area_.x - 0.1 && at.x <= area_.right() + 0.1 && at.y >= area_.y - 0.1 &&
            at.y <= area_.bottom() + 0.1)
          paintMarker(index, at);
  }

  /// Rows of the legend below the chart: entries side by side as far as they fit.
  std::vector<std::vector<std::size_t>> legendRows(double width) const {
    std::vector<std::vector<std::size_t>> rows;
    double used = 0;
    for (std::size_t i = 0; i < chart_.series.size(); ++i) {
      if (chart_.series[i].name.empty()) continue;
      const double entry = entryWidth(i);
      if (rows.empty() || used + entry > width) {
        rows.emplace_back();
        used = 0;
      }
      rows.back().push_back(i);
      used += entry;
    }
    return rows;
  }
  double entryWidth(std::size_t series) const { return 10 + width_(chart_.series[series].name, pageFontSize, false); }
  double legendHeight(double width) const { return pageLine * double(legendRows(width).size()); }

  void paintLegend() {
    double y = area_.bottom() + 2.3 * pageLine + pageLine;
    for (const auto& row : legendRows(area_.width)) {
      double x = area_.x;
      for (const std::size_t i : row) {
        const glm::dvec2 left(x, y - 0.9), right(x + 6, y - 0.9);
        if (chart_.series[i].isLine)
          page_.items.emplace_back(LineItem{{left, right}, colourOf(i), 0.3, chart_.series[i].isDashed ? 1.2 : 0.0});
        if (chart_.series[i].hasMarkers) paintMarker(i, 0.5 * (left + right));
        text({x + 7, y}, chart_.series[i].name, TextAnchor::start);
        x += entryWidth(i);
      }
      y += pageLine;
    }
  }

  const Chart& chart_;
  FigureDrawing& page_;
  TextWidth width_;
  PageRectangle area_;
  plots::ValueScale x_, y_;
};

}  // namespace

FigureDrawing drawCharts(const std::string& title, std::span<const Chart> charts, int columns) {
  FigureDrawing page = newPage(title);
  const double cellWidth = (page.width - 2 * pageMargin) / columns, cellHeight = columns == 1 ? 95 : 0.82 * cellWidth;
  for (std::size_t i = 0; i < charts.size(); ++i) {
    const std::size_t row = i / std::size_t(columns), column = i % std::size_t(columns);
    const PageRectangle cell{pageMargin + cellWidth * double(column), contentTop + cellHeight * double(row), cellWidth,
                             cellHeight};
    ChartPainter(charts[i], cell, page).paint();
    page.height = std::max(page.height, cell.bottom() + pageMargin);
  }
  return page;
}

FigureDrawing drawPictures(const std::string& title, std::span<const std::string> columns,
                           std::span<const PictureRow> rows, const std::string& note) {
  FigureDrawing page = newPage(title);
  const TextWidth width = cairoTextWidth(pageFont);
  constexpr double labelWidth = 7.5, gap = 1.2, widest = 55;
  const double available = page.width - 2 * pageMargin - labelWidth;
  const double side = std::min(widest, available / double(columns.size()) - gap);
  const auto left = [&](std::size_t column) { return pageMargin + labelWidth + (side + gap) * double(column); };
  double y = contentTop;
  std::size_t titleLines = 0;
  for (std::size_t c = 0; c < columns.size(); ++c) {
    const auto lines = brokenLines(columns[c], side, pageFontSize, width, true);
    titleLines = std::max(titleLines, lines.size());
    for (std::size_t i = 0; i < lines.size(); ++i)
      page.items.emplace_back(
          TextItem{{left(c) + side / 2, y + pageLine * double(i)}, lines[i], pageFontSize, TextAnchor::middle, true});
  }
  y += pageLine * double(titleLines) - 1.5;
  for (const PictureRow& row : rows) {
    double height = 0;  // of the pictures
    for (const PictureCell& cell : row.cells)
      if (cell.raster.width > 0) height = std::max(height, side * cell.raster.height / cell.raster.width);
    const auto labelLines = brokenLines(row.label, std::max(height, 14.), pageFontSize, width, true);
    for (std::size_t i = 0; i < labelLines.size(); ++i)
      page.items.emplace_back(TextItem{{pageMargin + pageLine * double(i + 1), y + height / 2},
                                       labelLines[i],
                                       pageFontSize,
                                       TextAnchor::middle,
                                       true,
                                       true});
    std::size_t textLines = 0;
    for (std::size_t c = 0; c < row.cells.size(); ++c) {
      const PictureCell& cell = row.cells[c];
      if (cell.raster.width > 0)
        page.items.emplace_back(
            PictureItem{{left(c), y, side, side * cell.raster.height / cell.raster.width}, cell.raster});
      std::size_t shown = 0;
      for (const std::string& line : cell.lines)
        for (const std::string& part : brokenLines(line, side, pageFontSize, width))
          page.items.emplace_back(TextItem{
              {left(c) + side / 2, y + height + pageLine * double(++shown)}, part, pageFontSize, TextAnchor::middle});
      textLines = std::max(textLines, shown);
    }
    y += height + pageLine * double(textLines) + 2.5;
  }
  if (!note.empty())
    for (const std::string& line : brokenLines(note, page.width - 2 * pageMargin, pageFontSize, width)) {
      page.items.emplace_back(TextItem{{pageMargin, y + 1.5}, line, pageFontSize});
      y += pageLine;
    }
  page.height = y + pageMargin;
  return page;
}

FigureDrawing drawTable(const std::string& title, std::span<const std::string> columns,
                        std::span<const std::vector<std::string>> rows) {
  FigureDrawing page = newPage(title);
  const TextWidth width = cairoTextWidth(pageFont);
  constexpr double rowHeight = 4.2;
  std::vector<double> lefts{pageMargin};
  for (std::size_t c = 0; c < columns.size(); ++c) {
    double widest = width(columns[c], pageFontSize, true);
    for (const auto& row : rows) widest = std::max(widest, width(row[c], pageFontSize, false));
    lefts.push_back(lefts.back() + widest + 5);
  }
  double y = contentTop + 1;
  const auto rule = [&](double at) {
    page.items.emplace_back(LineItem{{{pageMargin, at}, {std::min(lefts.back(), page.width - pageMargin), at}}});
  };
  for (std::size_t c = 0; c < columns.size(); ++c)
    page.items.emplace_back(TextItem{{lefts[c], y}, columns[c], pageFontSize, TextAnchor::start, true});
  rule(y + 1.2);
  for (const auto& row : rows) {
    y += rowHeight;
    for (std::size_t c = 0; c < columns.size(); ++c)
      page.items.emplace_back(TextItem{{lefts[c], y + 0.6}, row[c], pageFontSize});
  }
  rule(y + 1.8);
  page.height = y + 2 * pageMargin + 1;
  return page;
}

Raster shownPicture(const Image& picture) { return displayedOnWhite(picture, {}); }

Raster errorPicture(const Image& reference, const Image& picture, double range) {
  Raster map{reference.width, reference.height, rendering::errorMap(reference, picture, range)};
  putOnWhite(map);
  return map;
}

}  // namespace gonio::reproduction
