// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <filesystem>

#include "core/baselines/baselines.h"
#include "core/rendering/render_picture.h"
#include "tests/studies/comparison_records.h"

namespace gonio::study {

/// "MERL" of a file in the folder "merl".
std::string collectionOf(const std::filesystem::path& file);

/// Scores models of one material against its table.
class ComparisonJudge {
 public:
  /// Reads the material and renders its picture. @throws Error naming the file.
  ComparisonJudge(const std::filesystem::path& file, std::string collection, const rendering::RenderOptions& picture);

  const std::string& material() const { return material_; }
  const std::shared_ptr<const TabulatedBrdf>& table() const { return table_; }

  /// All but the budget.
  ComparisonRecord score(const std::string& model, const baselines::ComparedModel& built, double seconds) const;

 private:
  std::string material_, collection_;
  std::shared_ptr<const TabulatedBrdf> table_;
  rendering::RenderedComparison comparison_;
};

}  // namespace gonio::study
