// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "app/goniotool/comparison_picture.h"

#include <stb/stb_easy_font.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstring>

#include "core/rendering/error_maps.h"

namespace gonio::tool {

namespace {

constexpr int gap = 8, captionHeight = 20, legendHeight = 36, barHeight = 10;

constexpr DisplayColour ink{230, 230, 230}, paper{28, 28, 30};

class Canvas {
 public:
  Canvas(int width, int height) : picture_{width, height, std::vector<std::uint8_t>(std::size_t(width) * height * 4)} {
    fill(0, 0, width, height, paper);
  }

  void set(int x, int y, const DisplayColour& color) {
    if (x < 0 || y < 0 || x >= picture_.width || y >= picture_.height) return;
    std::uint8_t* pixel = &picture_.bytes[(std::size_t(y) * picture_.width + std::size_t(x)) * 4];
    std::copy(color.begin(), color.end(), pixel);
    pixel[3] = 255;
  }
  void fill(int left, int top, int width, int height, const DisplayColour& color) {
    for (int y = top; y < top + height; ++y)
      for (int x = left; x < left + width; ++x) set(x, y, color);
  }

  /// Small capitals of 7 pixels (Sean Barrett's stb_easy_font: quads of 4 vertices of x, y, z, colour).
  void text(int left, int top, const std::string& line) {
    struct Vertex {
      float x, y, z;
      std::uint8_t color[4];
    };
    std::vector<Vertex> vertices(line.size() * 64 + 64);
    std::string copy = line;
    const int quads = stb_easy_font_print(float(left), float(top), copy.data(), nullptr, vertices.data(),
                                          int(vertices.size() * sizeof(Vertex)));
    for (int quad = 0; quad < quads; ++quad) {
      const Vertex &first = vertices[std::size_t(quad) * 4], &opposite = vertices[std::size_t(quad) * 4 + 2];
      fill(int(first.x), int(first.y), int(opposite.x - first.x), int(opposite.y - first.y), ink);
    }
  }

  DisplayPicture take() { return std::move(picture_); }

 private:
  DisplayPicture picture_;
};

int textWidth(const std::string& line) {
  std::string copy = line;
  return stb_easy_font_width(copy.data());
}

std::string legendNumber(double value) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.3g", value);
  return buffer;
}

void drawLegend(Canvas& canvas, int left, int top, int width, double end) {
  for (int x = 0; x < width; ++x) canvas.fill(left + x, top, 1, barHeight, viridis(double(x) / std::max(1, width - 1)));
  for (int tick = 0; tick <= 2; ++tick) {
    const std::string label = legendNumber(end * tick / 2);
    const int labelWidth = textWidth(label), at = left + tick * (width - 1) / 2;
    canvas.fill(at, top + barHeight, 1, 3, ink);
    canvas.text(std::clamp(at - labelWidth / 2, left, left + width - labelWidth), top + barHeight + 6, label);
  }
}

}  // namespace

DisplayPicture comparisonPicture(const Image& reference, const Image& test, const std::string& referenceName,
                                 const std::string& testName, double exposure, ToneMap toneMap) {
  const int width = reference.width, height = reference.height, step = width + gap;
  Canvas canvas(3 * step + gap, captionHeight + height + legendHeight);
  const double end = errorRange(reference, {&test, 1});
  const std::array<std::vector<std::uint8_t>, 3> panels{toDisplayBytes(reference, exposure, toneMap),
                                                        toDisplayBytes(test, exposure, toneMap),
                                                        errorMap(reference, test, end)};
  for (int panel = 0; panel < 3; ++panel) {
    const std::vector<std::uint8_t>& bytes = panels[std::size_t(panel)];
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x)
        if (const std::size_t i = 4 * reference.index(x, y); bytes[i + 3] > 0)
          canvas.set(gap + panel * step + x, captionHeight + y, {bytes[i], bytes[i + 1], bytes[i + 2]});
  }
  canvas.text(gap, 7, referenceName);
  canvas.text(gap + step, 7, testName);
  canvas.text(gap + 2 * step, 7, "luminance error");
  drawLegend(canvas, gap + 2 * step, captionHeight + height + gap, width, end);
  return canvas.take();
}

}  // namespace gonio::tool
