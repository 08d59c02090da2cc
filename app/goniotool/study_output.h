// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <string>
#include <vector>

#include "app/goniotool/study_files.h"
#include "core/study/pareto.h"

namespace gonio::tool {

/// @throws Error that names the folder.
void makeFolder(const std::string& path);

/// Collects the results of a study, material by material, for the final report.
class StudyOutput {
 public:
  StudyOutput(std::string folder, StudyFacts facts, const study::Budget& budget = {})
      : folder_(std::move(folder)), facts_(std::move(facts)), budget_(budget) {}

  void add(const StudiedMaterial& material);
  /// Writes the files of the medians if there are several materials.
  void writeSummary();
  /// @param further additional members at the end of the JSON report.
  void print(const Tool& tool, bool complete, double seconds, const Json& further = Json::object());

 private:
  /// Records the best representation within the limits, if there are limits. Precondition: the material is complete.
  void choose(const StudiedMaterial& material);

  std::string folder_;
  StudyFacts facts_;
  study::Budget budget_;
  std::string text_;
  std::vector<std::vector<study::StudyRecord>> all_;
  Json records_ = Json::array(), chosen_ = Json::array();
};

}  // namespace gonio::tool
