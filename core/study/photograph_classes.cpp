// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/study/photograph_classes.h"

#include "core/study/training_files.h"

namespace gonio::study {

std::vector<std::size_t> photographClasses(const photograph::PhotographPrior& prior) {
  std::vector<std::size_t> classes;
  for (std::size_t m = 0; m < prior.trainingCount(); ++m)
    classes.push_back(highlightContrast(*photograph::trainingTable(prior, m)) >= glossyContrast ? 1 : 0);
  return classes;
}

}  // namespace gonio::study
