// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <array>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/brdf/tabulated_brdf.h"
#include "core/dictionary/principal_components.h"
#include "core/rendering/render_picture.h"
#include "core/support/task_control.h"

namespace gonio::reproduction {

/// Databases of measured materials: Matusik et al. 2003, Dupuy and Jakob 2018, Nielsen et al. 2015.
enum class MaterialSet { merl, rgl, dtu };
/// Names on the command line and in texts, in the order of the enumeration.
inline constexpr std::array<std::string_view, 3> materialSetNames{"merl", "rgl", "dtu"};

/// A material that a figure shows, and which others can replace it where it is missing, the most similar first: of the
/// same kind, with similar parameters of their published SGD fits (Bagher et al. 2012).
struct Subject {
  MaterialSet set = MaterialSet::merl;
  std::string_view name;
  std::vector<std::string_view> substitutes = {};
};

struct InputMaterial {
  std::string path;  ///< as for documents::openMaterial()
  std::string name;  ///< stem of the file, as materialName()
  MaterialSet set = MaterialSet::merl;
  std::string_view replaced = {};  ///< the subject for which it is a substitute; empty: none
};

/// A name as the dissertation writes it: lower case, hyphens, without "_rgb" at the end.
std::string materialName(std::string_view stem);

/// The name in texts: "gold-metallic-paint3", or with what it stands for: "gold-metallic-paint3 (for
/// gold-metallic-paint2)".
std::string shownName(const InputMaterial& material);

struct InputOptions {
  /// Folders of measured files, in the order of MaterialSet. Empty: the bundled near-measured copies; for RGL the
  /// bundled measured files and copies of the others.
  std::array<std::string, 3> folders;
  bool quick = false;  ///< four materials where a figure uses whole sets, small pictures, few samples
};

/// The materials of a run, and what several figures share.
class Inputs {
 public:
  /// Lists the files. @throws Error that names a folder that does not exist or has no measured material.
  explicit Inputs(InputOptions options);

  bool quick() const { return options_.quick; }
  const std::string& folder(MaterialSet set) const { return options_.folders[std::size_t(set)]; }
  std::span<const InputMaterial> materials(MaterialSet set) const { return sets_[std::size_t(set)]; }
  /// The four materials of a quick run that are in one of the sets: one of each kind.
  std::vector<InputMaterial> testMaterials(std::span<const MaterialSet> sets) const;
  /// The training set of acquisition: MERL and RGL, of a quick run every fourth material of each.
  std::vector<InputMaterial> trainingMaterials() const;
  /// The material of a subject or its first substitute that exists. @throws Error that names it and the set.
  InputMaterial find(const Subject& subject) const;

  /// A sentence for each set: where its materials come from.
  std::vector<std::string> origins() const;
  /// SHA-256 of a material's file or of its bundled data, read once.
  const std::string& hash(const InputMaterial& material);

  /// The table of a material, the mean of both orders of the directions. The last tables stay in memory.
  std::shared_ptr<const TabulatedBrdf> table(const InputMaterial& material, const TaskControl& control);
  /// Principal components of a training set on the MERL grid; those of the last training set stay in memory. About
  /// 30 s for 130 materials on two cores. @throws Error for a file on another grid; Cancelled.
  std::shared_ptr<const dictionary::PrincipalComponents> basis(std::span<const InputMaterial> training,
                                                               const TaskControl& control);

  /// Size and samples of pictures. Rendered SNRs exclude their noise (rendering::RenderedComparison).
  rendering::RenderOptions picture() const;

 private:
  InputOptions options_;
  std::array<std::vector<InputMaterial>, 3> sets_;
  std::map<std::string, std::string> hashes_;
  std::vector<std::pair<std::string, std::shared_ptr<const TabulatedBrdf>>> tables_;
  std::string basisKey_;
  std::shared_ptr<const dictionary::PrincipalComponents> basis_;
};

}  // namespace gonio::reproduction
