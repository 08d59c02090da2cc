// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/reproduction/charts.h"
#include "core/reproduction/figure_record.h"

namespace gonio::reproduction {

struct ComparedBrdf {
  std::string label;
  std::shared_ptr<const Brdf> brdf;
};

/// Pictures of materials beside the same rendered from several representations: for each material a row of pictures
/// with rendered SNRs, and a row of the absolute differences on a common scale.
class PictureRows {
 public:
  /// @param picture size and samples.
  explicit PictureRows(const rendering::RenderOptions& picture) : picture_(picture) {}

  /// Renders a material and its representations in rendering::comparisonScene(). All rows need as many of them.
  /// @param columns their labels are the titles of the columns, from the first row. @return rendered SNRs, dB.
  /// @throws Cancelled.
  std::vector<double> add(const std::string& label, const Brdf& reference, std::span<const ComparedBrdf> compared,
                          const TaskControl& control);

  figures::FigureDrawing draw(const std::string& title) const;
  /// Material, representation, rendered SNR.
  io::CsvTable table() const;

 private:
  rendering::RenderOptions picture_;
  std::vector<std::string> columns_{"Reference"};
  std::vector<PictureRow> rows_;
  std::vector<std::string> materials_, representations_;
  std::vector<double> ratios_;
};

}  // namespace gonio::reproduction
