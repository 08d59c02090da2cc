// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
//
// gonio_studies deviation_nodes [--every N]: prints the nodes of libraryDeviationNodes() of both energies, computed
// from the bundled materials or from every Nth of them. Takes one minute.
#include <cstdio>
#include <string>

#include "core/factorization/deviation_grid.h"
#include "core/materials/bundled_library.h"
#include "core/materials/material.h"
#include "tests/studies/study_program.h"

namespace gonio::study::deviation_nodes_study {

namespace {

int study(int count, char** values) {
  const std::size_t every = count == 3 && std::string(values[1]) == "--every" ? std::stoul(values[2]) : 1;
  std::vector<double> sum, printed;
  const std::vector<std::string> paths = materials::libraryTrainingPaths();
  for (std::size_t i = 0; i < paths.size(); i += every) {
    const auto table = meanOfOrders(materials::readLibraryMaterial(paths[i]).tabulated({}));
    const std::vector<double> energy = factorization::publishedDeviationEnergy(*table);
    const std::vector<double> ofRho = factorization::publishedDeviationEnergy(*table, {}, DataTransform::none);
    sum.resize(energy.size());
    printed.resize(energy.size());
    for (std::size_t j = 0; j < energy.size(); ++j) {
      sum[j] += energy[j];
      printed[j] += ofRho[j];
    }
  }
  for (const std::vector<double>& energy : {sum, printed}) {
    for (const double node : factorization::deviationNodes(energy, factorization::defaultDeviations))
      std::printf("%.9g, ", node);
    std::printf("\n\n");
  }
  return 0;
}

}  // namespace

GONIO_STUDY(study)

}  // namespace gonio::study::deviation_nodes_study
