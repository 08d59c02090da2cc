// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/export/shaders/reciprocal_lobes.h"

#include <algorithm>
#include <cmath>

#include "core/fitting/bounded_least_squares.h"

namespace gonio::exports {

namespace {

using fitting::LinearMatrix;
using fitting::LinearVector;

constexpr double sharpestAlpha = 0.002, widestAlpha = 1;
constexpr double maxStrength = 1e3;  // of F_0 and F_90: what a fit never reaches
constexpr std::size_t widthCandidates = 14;
constexpr int coarseIterations = 6, fineIterations = 25, colourIterations = 15;

/// The linear problem of some widths. Columns: Lambert, then F_0 and F_90 of each lobe.
class LobeProblem {
 public:
  LobeProblem(const Brdf& material, const PictureCells& cells) : cells_(cells) {
    const auto rows = Eigen::Index(cells.residualCount());
    const std::vector<double> residuals = cells.residualsOfMaterial(material);
    target_ = Eigen::Map<const LinearMatrix>(residuals.data(), rows, 3);
    lambert_ = columns([](const models::SurfaceGeometry&) { return Rgb(1 / pi); }, {}).leftCols(1);
  }

  /// Columns of F_0 and F_90.
  LinearMatrix lobeColumns(const GgxAlpha& alpha, double rotation) const {
    return columns(
        [alpha](const models::SurfaceGeometry& g) {
          const double lobe = correlatedGgx(g, alpha), edge = schlickWeight(g.cosD);
          return Rgb(lobe * (1 - edge), lobe * edge, 0);
        },
        {.isotropic = alpha.isotropic(), .rotation = rotation});
  }
  LinearMatrix withLambert(std::span<const LinearMatrix> lobes) const {
    LinearMatrix all(lambert_.rows(), 1 + 2 * Eigen::Index(lobes.size()));
    all.leftCols(1) = lambert_;
    for (std::size_t j = 0; j < lobes.size(); ++j) all.middleCols(1 + 2 * Eigen::Index(j), 2) = lobes[j];
    return all;
  }
  const LinearMatrix& target() const { return target_; }

 private:
  template <typename Formula>
  LinearMatrix columns(Formula formula, const FormulaTraits& traits) const {
    const std::vector<double> residuals = cells_.residualsOf(*makeFormulaBrdf(formula, traits));
    return Eigen::Map<const LinearMatrix>(residuals.data(), Eigen::Index(cells_.residualCount()), 3).leftCols(2);
  }

  const PictureCells& cells_;
  LinearMatrix target_;   ///< a column for each channel
  LinearMatrix lambert_;  ///< one column
};

/// Strengths [column][channel] of the least squares, >= 0, the albedo of the body at most 1.
LinearMatrix solveStrengths(const LinearMatrix& normal, const LinearMatrix& rightSides) {
  constexpr double ridge = 1e-9;
  LinearMatrix regularised = normal, result(normal.rows(), 3);
  regularised.diagonal() *= 1 + ridge;
  LinearVector upper = LinearVector::Constant(normal.rows(), maxStrength);
  upper(0) = 1;
  for (int channel = 0; channel < 3; ++channel)
    result.col(channel) =
        fitting::solveBounded(regularised, rightSides.col(channel), LinearVector::Zero(normal.rows()), upper)
            .cwiseMax(0);
  return result;
}

/// |residual|^2 - |target|^2 of a solution.
double relativeCost(const LinearMatrix& normal, const LinearMatrix& rightSides, const LinearMatrix& x) {
  return (x.transpose() * normal * x).trace() - 2 * (x.transpose() * rightSides).trace();
}

/// The widths of the series that explain most, found one after the other.
std::vector<double> greedyWidths(const LobeProblem& problem, std::size_t count, const TaskControl& control) {
  std::vector<double> alphas(widthCandidates);
  std::vector<LinearMatrix> lobes;
  for (std::size_t j = 0; j < widthCandidates; ++j) {
    control.throwIfStopped();
    alphas[j] = widestAlpha * std::pow(sharpestAlpha / widestAlpha, double(j) / double(widthCandidates - 1));
    lobes.push_back(problem.lobeColumns(GgxAlpha(alphas[j]), 0));
  }
  const LinearMatrix all = problem.withLambert(lobes);
  const LinearMatrix normal = all.transpose() * all, right = all.transpose() * problem.target();
  std::vector<Eigen::Index> used{0};
  std::vector<double> found;
  for (double lowest = 0; found.size() < count;) {
    std::size_t best = widthCandidates;
    for (std::size_t j = 0; j < widthCandidates; ++j) {
      if (std::ranges::find(found, alphas[j]) != found.end()) continue;
      std::vector<Eigen::Index> trial = used;
      trial.insert(trial.end(), {Eigen::Index(1 + 2 * j), Eigen::Index(2 + 2 * j)});
      const LinearMatrix n = normal(trial, trial), b = right(trial, Eigen::all);
      if (const double cost = relativeCost(n, b, solveStrengths(n, b)); cost < lowest) {
        lowest = cost;
        best = j;
      }
    }
    if (best == widthCandidates) break;
    used.insert(used.end(), {Eigen::Index(1 + 2 * best), Eigen::Index(2 + 2 * best)});
    found.push_back(alphas[best]);
  }
  std::ranges::sort(found, std::greater{});
  return found;
}

/// Widths and the direction of the grain as numbers of a search: ln alpha for each lobe, or ln alpha_x and ln alpha_y
/// and, last, the rotation.
struct WidthCoding {
  std::size_t lobes;
  bool isotropic;

  GgxAlpha widths(std::span<const double> x, std::size_t lobe) const {
    return isotropic ? GgxAlpha(std::exp(x[lobe])) : GgxAlpha(std::exp(x[2 * lobe]), std::exp(x[2 * lobe + 1]));
  }
  double rotation(std::span<const double> x) const { return isotropic || lobes == 0 ? 0 : x.back(); }

  fitting::BoundedVariables variables(std::span<const double> alphas, double rotation) const {
    constexpr double stretch = 0.4;  // of ln alpha, where a grain is looked for
    fitting::BoundedVariables v;
    for (const double alpha : alphas) {
      if (isotropic) {
        v.start.push_back(std::log(alpha));
      } else {
        v.start.push_back(std::log(alpha) + stretch);
        v.start.push_back(std::log(alpha) - stretch);
      }
    }
    v.minimum.assign(v.start.size(), std::log(sharpestAlpha / 2));
    v.maximum.assign(v.start.size(), std::log(widestAlpha));
    if (isotropic) return v;
    v.start.push_back(rotation);
    v.minimum.push_back(rotation - halfPi);
    v.maximum.push_back(rotation + halfPi);
    return v;
  }
};

LinearMatrix columnsAt(const LobeProblem& problem, const WidthCoding& coding, std::span<const double> x) {
  std::vector<LinearMatrix> lobes;
  for (std::size_t j = 0; j < coding.lobes; ++j)
    lobes.push_back(problem.lobeColumns(coding.widths(x, j), coding.rotation(x)));
  return problem.withLambert(lobes);
}

LinearMatrix strengthsOf(const LobeProblem& problem, const LinearMatrix& columns) {
  return solveStrengths(columns.transpose() * columns, columns.transpose() * problem.target());
}

std::vector<double> refinedWidths(const LobeProblem& problem, const WidthCoding& coding,
                                  const fitting::BoundedVariables& variables, int iterations,
                                  const TaskControl& control) {
  const auto function = [&](std::span<const double> x, std::span<double> residuals) {
    const LinearMatrix columns = columnsAt(problem, coding, x);
    Eigen::Map<LinearMatrix>(residuals.data(), columns.rows(), 3) =
        columns * strengthsOf(problem, columns) - problem.target();
  };
  auto found =
      fitting::boundedLeastSquares(function, std::size_t(problem.target().size()), variables, iterations, control.stop);
  control.throwIfStopped();
  return found;
}

double costAt(const LobeProblem& problem, const WidthCoding& coding, std::span<const double> x) {
  const LinearMatrix columns = columnsAt(problem, coding, x);
  return (columns * strengthsOf(problem, columns) - problem.target()).squaredNorm();
}

std::vector<double> bestWidths(const LobeProblem& problem, const WidthCoding& coding, std::span<const double> alphas,
                               const TaskControl& control) {
  if (coding.isotropic) return refinedWidths(problem, coding, coding.variables(alphas, 0), fineIterations, control);
  std::vector<double> best;
  for (int k = 0; k < 4; ++k) {
    auto found = refinedWidths(problem, coding, coding.variables(alphas, k * pi / 4), coarseIterations, control);
    if (best.empty() || costAt(problem, coding, found) < costAt(problem, coding, best)) best = std::move(found);
  }
  fitting::BoundedVariables variables = coding.variables(alphas, best.back());
  variables.start = best;
  return refinedWidths(problem, coding, variables, fineIterations, control);
}

ReciprocalLobes lobesAt(const LobeProblem& problem, const WidthCoding& coding, std::span<const double> x) {
  const LinearMatrix strengths = strengthsOf(problem, columnsAt(problem, coding, x));
  const auto row = [&](Eigen::Index i) { return Rgb(strengths(i, 0), strengths(i, 1), strengths(i, 2)); };
  ReciprocalLobes result{.diffuse = row(0), .lobes = {}, .rotation = coding.rotation(x)};
  for (std::size_t j = 0; j < coding.lobes; ++j) {
    const auto first = 1 + 2 * Eigen::Index(j);
    if (maxChannel(row(first)) > 0 || maxChannel(row(first + 1)) > 0)
      result.lobes.push_back({coding.widths(x, j), row(first), row(first + 1), Rgb(1)});
  }
  std::ranges::stable_sort(result.lobes, std::greater{}, [](const auto& lobe) { return lobe.alpha.mean(); });
  return result;
}

/// The colours of lobes, with their largest values.
template <typename Visit>
void visitColours(ReciprocalLobes& lobes, Visit visit) {
  visit(lobes.diffuse, 1.0);
  for (ReciprocalLobes::Lobe& lobe : lobes.lobes) {
    visit(lobe.normal, maxStrength);
    visit(lobe.edge, maxStrength);
    visit(lobe.tint82, 1.0);
  }
}

}  // namespace

bool ReciprocalLobes::isIsotropic() const {
  return std::ranges::all_of(lobes, [](const Lobe& lobe) { return lobe.alpha.isotropic(); });
}

std::unique_ptr<const Brdf> reciprocalLobesBrdf(const ReciprocalLobes& lobes) {
  return makeFormulaBrdf(
      [lobes](const models::SurfaceGeometry& g) {
        Rgb sum = lobes.diffuse / pi;
        for (const ReciprocalLobes::Lobe& lobe : lobes.lobes)
          sum += correlatedGgx(g, lobe.alpha) * tintedSchlick(g.cosD, lobe.normal, lobe.edge, lobe.tint82);
        return sum;
      },
      {.isotropic = lobes.isIsotropic(), .rotation = lobes.rotation});
}

ReciprocalLobes fitReciprocalLobes(const Brdf& material, const PictureCells& cells, std::size_t count,
                                   const TaskControl& control) {
  const LobeProblem problem(material, cells);
  const std::vector<double> alphas = greedyWidths(problem, count, control);
  control.report(0.3);
  const WidthCoding coding{alphas.size(), cells.isIsotropic()};
  const std::vector<double> x = alphas.empty() ? std::vector<double>() : bestWidths(problem, coding, alphas, control);
  ReciprocalLobes lobes = lobesAt(problem, coding, x);
  control.report(1);
  return lobes;
}

ReciprocalLobes refineLobes(const Brdf& material, const PictureCells& cells, const ReciprocalLobes& start,
                            LobesFormula formula, const TaskControl& control) {
  const std::vector<double> target = cells.residualsOfMaterial(material);
  ReciprocalLobes lobes = start;
  fitting::BoundedVariables variables;
  visitColours(lobes, [&](Rgb& colour, double largest) {
    for (int c = 0; c < 3; ++c) {
      variables.start.push_back(colour[c]);
      variables.minimum.push_back(0);
      variables.maximum.push_back(largest);
    }
  });
  const auto set = [&](std::span<const double> x) {
    std::size_t next = 0;
    visitColours(lobes, [&](Rgb& colour, double) {
      for (int c = 0; c < 3; ++c) colour[c] = x[next++];
    });
  };
  const auto function = [&](std::span<const double> x, std::span<double> residuals) {
    set(x);
    const std::vector<double> found = cells.residualsOf(*formula(lobes));
    std::ranges::transform(found, target, residuals.begin(), std::minus{});
  };
  set(fitting::boundedLeastSquares(function, target.size(), variables, colourIterations, control.stop));
  control.throwIfStopped();
  control.report(1);
  return lobes;
}

}  // namespace gonio::exports
