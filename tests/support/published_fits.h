// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <string>
#include <vector>

#include "core/metrics/brdf_metric.h"
#include "core/models/model.h"

/// Fits of models to the MERL materials that their authors published, in the conventions of Gonio's models.
namespace gonio::test {

struct PublishedFit {
  std::string material;  ///< as MERL's files are named
  models::ParameterValues parameters;
};

struct PublishedSet {
  std::string name;  ///< "ngan-ward"
  const models::Model* model;
  metrics::BrdfMetric metric;  ///< what the authors minimised
  std::vector<PublishedFit> fits;
};

/// The sets of Ngan et al. 2005, Löw et al. 2012 and Bagher et al. 2012 whose model is registered.
/// @param folder of the tables (../shared/data/tables). @throws Error naming a file that cannot be read.
std::vector<PublishedSet> readPublishedSets(const std::string& folder);

}  // namespace gonio::test
