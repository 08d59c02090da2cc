// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/baselines/baselines.h"
#include "core/models/model.h"
#include "core/plots/svg_drawing.h"
#include "core/support/task_control.h"

namespace gonio::study {

struct BuildContext;
struct BuiltRepresentation;
struct Representation;

/// A group of representations that are selected together.
struct RepresentationFamily {
  std::string_view id;      ///< on the command line, in Python and in files
  std::string_view name;    ///< for lists, e.g. "PDV factors"
  std::string_view hint;    ///< a sentence for tooltips
  std::string_view colour;  ///< of its points in plots, CSS; black stands for the colour of the text
  bool isDefault = false;   ///< whether a study measures it unless others are selected
};

/// What a budget counts.
enum class BudgetUnit {
  none,          ///< there is no budget
  numbers,       ///< fitted parameters of a model, which the user cannot choose
  terms,         ///< of factors
  coefficients,  ///< of a sparse code, per channel
  components,    ///< principal components, per channel
  bytes          ///< maximum size
};

/// What *Use This Representation* does in the editor.
enum class RepresentationUse {
  showInPreview,
  editModel,  ///< the model becomes the one that is edited
  showCode    ///< the panel of the representation shows the code
};

/// The points of a representation in plots.
struct PointStyle {
  plots::Marker marker{};
  bool hollow = false;
};

/// A row of the table of representations: everything that the library, the command line, Python and the editor know of
/// a kind of representation. representation_table.cpp contains the rows.
struct RepresentationKind {
  std::string_view id;     ///< on the command line, in Python and in files, e.g. "factors-3d"
  std::string_view label;  ///< for display, e.g. "PDV factors, three curves"
  const RepresentationFamily* family = nullptr;
  PointStyle style;
  /// Makes the representation. @throws Error that states what is missing; Cancelled.
  BuiltRepresentation (*build)(BuildContext& context, const Representation& representation,
                               const TaskControl& control) = nullptr;
  BudgetUnit unit = BudgetUnit::none;
  int maxBudget = 0;             ///< of the budgets that a user can choose; 0: there are none
  std::string_view legend = {};  ///< name of its points in a legend; empty: the label
  RepresentationUse use = RepresentationUse::showInPreview;
  bool needsFurtherData = false;                  ///< more than the material: a training set or a published table
  bool isOptional = false;                        ///< not selected with its family, only by its own id
  std::string_view formerId = {};                 ///< of older files; empty: none
  const models::Model* model = nullptr;           ///< of a fit
  const baselines::Baseline* baseline = nullptr;  ///< of a baseline

  /// Whether the user chooses a budget.
  bool hasBudget() const { return maxBudget > 0; }
  /// Whether it is a number of parts, not a limit of the size.
  bool hasCountedBudget() const {
    return unit == BudgetUnit::terms || unit == BudgetUnit::coefficients || unit == BudgetUnit::components;
  }
  /// Name of its points in a legend.
  std::string_view legendName() const { return legend.empty() ? label : legend; }
};

/// All families, in the order of display.
std::span<const RepresentationFamily* const> representationFamilies();
/// All rows of the table, in the order of measurement and display: the rows of a family follow one another. The models
/// and the baselines contribute rows from their registries.
std::span<const RepresentationKind> representationKinds();
/// A row by its id or the id that it has in older files; null if there is none.
const RepresentationKind* findRepresentationKind(std::string_view id);

/// A representation of a material at one budget.
struct Representation {
  const RepresentationKind* kind = nullptr;
  double budget = 0;  ///< number of terms, of coefficients or components per channel, or of fitted parameters; of a
                      ///< baseline: maximum bytes; 0 if there is no budget

  bool operator==(const Representation&) const = default;
  std::string id() const { return std::string(kind->id); }
  std::string label() const { return std::string(kind->label); }
  /// E.g. "10 terms"; "" if there is no budget.
  std::string budgetText() const;
  /// Label and budget, e.g. "PDV factors, three curves, 10 terms".
  std::string fullLabel() const;
  /// The same without a budget that the user cannot choose: "GGX", not "GGX, 8 numbers".
  std::string shortLabel() const;
};

/// The ids of the families with isDefault.
std::vector<std::string> defaultFamilies();

/// Maximum per channel: the `.code` format has a 16-bit count.
inline constexpr int maxCodeCoefficients = 65535;
/// Maximum budget of a baseline.
inline constexpr int maxBaselineBytes = 100'000'000;

/// A selection of representations to measure.
struct RepresentationChoice {
  /// Ids of families, which stand for all their rows that are not optional, and of single rows.
  std::vector<std::string> names = defaultFamilies();
  /// Of PDV factors. The budgets of baselines are the sizes in bytes of PDV files of three factors with these numbers
  /// of terms, as long as a larger budget changes the baseline.
  std::vector<int> terms{1, 2, 3, 5, 8, 10, 14, 20};
  std::vector<std::size_t> coefficients{32, 64, 128, 256, 512, 1024, 2048};  ///< per channel
  std::vector<int> components{4, 8, 16, 32, 64, 128};                        ///< per channel

  /// Whether a name selects the row.
  bool selects(const RepresentationKind& kind) const;
  /// Selects only the given rows of a family, if its name is among the names; no ids: changes nothing.
  /// @throws Error that lists the ids of the family.
  void restrict(std::string_view family, std::span<const std::string> ids);
};

/// The selected representations, in the order of the table.
/// @throws Error for an unknown name, which lists the ids of the families.
std::vector<Representation> representationsOf(const RepresentationChoice& choice);

/// The ids of the families with rows that need only the material, in order.
std::vector<std::string> familiesWithoutFurtherData();

/// A representation by its id (or the id in older files) and budget as in the records of a study, e.g. ("factors-3d",
/// 10). Rows that need further data are not found. @throws Error that states what was found and what was expected.
Representation representationById(std::string_view id, std::optional<double> budget = {});

}  // namespace gonio::study
