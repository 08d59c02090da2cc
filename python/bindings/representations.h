// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/dictionary/alternatives/patch_dictionary.h"
#include "core/dictionary/alternatives/separated_components.h"
#include "core/factorization/pdv_factors.h"
#include "core/materials/dictionary_file.h"
#include "python/bindings/materials.h"

namespace gonio::python {

/// Factors in Python. Immutable.
struct PyFactors {
  std::shared_ptr<const factorization::PdvFactors> factors;
  std::vector<double> residuals;
  double seconds = 0;
};

/// Principal components in Python. Immutable.
struct PyBasis {
  std::shared_ptr<const dictionary::PrincipalComponents> components;
  std::vector<std::string> learnedFrom;
  bool isOfAtoms = false;  ///< of atomComponents(): for the choice of directions alone

  /// The components of a training set. @throws Error for atoms.
  const std::shared_ptr<const dictionary::PrincipalComponents>& ofMaterials() const {
    if (isOfAtoms)
      throw Error(
          "the basis consists of dictionary atoms (gonio.learn_atoms()), which serve gonio.plan() alone; expected one "
          "of "
          "gonio.learn_basis()");
    return components;
  }
};

/// Both bases of dictionary::SeparatedComponents.
using PySeparatedBasis = std::shared_ptr<const dictionary::SeparatedComponents>;

using PyPatchDictionaryPtr = std::shared_ptr<dictionary::PatchDictionary>;
using PyDictionaryPtr = std::shared_ptr<const materials::NamedEnsemble>;

}  // namespace gonio::python
