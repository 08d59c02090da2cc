// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "core/brdf/tabulated_brdf.h"
#include "core/support/task_control.h"

/// Data of plots of a BRDF, without drawing. Angles are in rad; values are linear RGB, 1/sr (conventions of
/// core/math/types.h), times the chosen CosineFactor.
namespace gonio::plots {

/// The factor of plotted values, which plots state in the title of the axis.
enum class CosineFactor {
  none,      ///< f
  incident,  ///< f cos theta_i, the integrand of reflected light
  outgoing   ///< f cos theta_o, proportional to the power that a distant detector of fixed area receives from an
             ///< illuminated spot
};

/// The plotted channel.
enum class Channel { luminance, red, green, blue };
double channelOf(Channel channel, const Rgb& value);

enum class PointState : std::uint8_t {
  known,
  belowHorizon,  ///< a direction is below the surface
  notMeasured    ///< the table has no valid cell around this point
};

struct PlottedValues {
  std::vector<Rgb> values;         ///< 0 if the state is not `known`
  std::vector<PointState> states;  ///< one per value

  /// The value of a channel; NaN if it is not known.
  double at(std::size_t index, Channel channel) const;
};

/// Evaluates pairs of directions. @param coverage if not null, the measurement that determines which points are
/// measured, such as the base of an edited measurement.
PlottedValues evaluatePlotted(const Brdf& brdf, std::span<const DirectionPair> pairs, CosineFactor cosine,
                              const TabulatedBrdf* coverage = nullptr);

/// Distance from the horizon at which plots over angles end, rad (0.05 degrees): models are 0 on the horizon, and lines
/// would drop to 0 there.
inline constexpr double horizonMargin = radians(0.05);

/// `count` >= 2 ascending values from exactly `first` to exactly `last`, dense about `centre` (clamped to the range),
/// for curves with a narrow highlight: the spacing grows with the distance from the centre as a hyperbolic sine, by a
/// factor of about `density` at the far end.
std::vector<double> nodesAbout(double centre, double first, double last, int count, double density = 30);

/// Values of a BRDF over one angle.
struct Curve {
  std::vector<double> angles;  ///< rad, ascending
  PlottedValues points;        ///< one per angle
};

enum class SectionAxis { thetaH, thetaD, thetaO };

/// The definition of a section: the varying angle, and the fixed ones.
struct Section {
  SectionAxis axis = SectionAxis::thetaO;
  /// For SectionAxis::thetaO: the light has this polar angle and azimuth pi; the viewer has the signed polar angle
  /// theta_o in the plane of azimuth `planeAzimuth` (0: plane of incidence). There theta_o = theta_i is the mirror
  /// direction and theta_o = -theta_i is retro-reflection. Rad.
  double thetaI = radians(45), planeAzimuth = 0;
  /// Fixed angles, rad. For SectionAxis::thetaH: thetaD and phiD; for SectionAxis::thetaD: thetaH and phiD. With thetaH
  /// = 0, theta_d is the angle of incidence of mirror reflection.
  double thetaH = 0, thetaD = radians(45), phiD = halfPi;
  CosineFactor cosine = CosineFactor::none;
  int count = 721;
};

/// The curve of a section: theta_h and theta_d over [0, pi/2 - horizonMargin], theta_o over
/// [-pi/2 + horizonMargin, pi/2 - horizonMargin]; nodes are dense where a highlight is expected. Under 1 ms for models.
/// @param coverage as in evaluatePlotted().
Curve sectionCurve(const Brdf& brdf, const Section& section, const TabulatedBrdf* coverage = nullptr);

/// The value of a channel, linear between the nodes of a curve; NaN outside them and next to a point that is not known.
double valueAt(const Curve& curve, double angle, Channel channel);

/// The lobe in the plane of incidence: the section over theta_o at planeAzimuth = 0.
Curve polarLobe(const Brdf& brdf, double thetaI, CosineFactor cosine, const TabulatedBrdf* coverage = nullptr);

/// Spacing of the horizontal axis of a slice, as of theta_h; |Dp| is spaced likewise.
enum class ThetaHSpacing {
  linear,     ///< uniform
  squareRoot  ///< theta_h = u^2 pi/2 for u in [0, 1]: as in MERL tables, which magnifies the highlight
};

/// The coordinates of a slice. All are those of pairs whose azimuth is fixed, with the mirror direction at the left
/// edge, where the vertical coordinate is the angle of incidence.
enum class SliceCoordinates {
  halfDifference,     ///< theta_h, theta_d for a phi_d
  halfOut,            ///< theta_h, theta_o for a phi_h
  projectedDeviation  ///< |Dp|, theta_r for a phi
};

/// A row for each of SliceCoordinates: the columns of its CoordinateSystem, and their symbols.
struct SliceAxes {
  std::string_view system;          ///< CoordinateSystem::id
  std::size_t across, up, azimuth;  ///< indices of CoordinateSystem::columns
  const char *acrossSymbol, *upSymbol, *azimuthSymbol, *azimuthMeaning;
  double acrossEnd = halfPi;  ///< largest value of the horizontal axis: rad, or |Dp|
};
const SliceAxes& axesOf(SliceCoordinates coordinates);

/// The values of a BRDF over two coordinates for one azimuth, as an image.
struct Slice {
  int width = 0, height = 0;
  SliceCoordinates coordinates = SliceCoordinates::halfDifference;
  ThetaHSpacing spacing = ThetaHSpacing::squareRoot;  ///< of the horizontal axis
  double azimuth = halfPi;                            ///< rad
  PlottedValues cells;                                ///< columns run fastest

  /// Coordinates at the centre of a column (rad, or |Dp|) or row (rad).
  double across(int column) const;
  double up(int row) const;
  std::size_t index(int column, int row) const { return std::size_t(row) * std::size_t(width) + std::size_t(column); }
};

/// Conversion of theta_h (rad) to a fraction of the axis, [0, 1], and back.
double thetaHFraction(ThetaHSpacing spacing, double thetaH);
double thetaHAt(ThetaHSpacing spacing, double fraction);

/// A slice of `size` x `size` cells (90 in MERL tables). Takes a few ms. Of an anisotropic material it depends on where
/// the azimuth 0 is: at the half vector (half-difference) or the viewer. @param coverage as in evaluatePlotted().
Slice sliceOf(const Brdf& brdf, SliceCoordinates coordinates, double azimuth, ThetaHSpacing spacing,
              CosineFactor cosine, const TabulatedBrdf* coverage = nullptr, int size = 90);

/// Directional albedo (the integral of f cos theta_i over the light's hemisphere, without unit) for viewers at azimuth
/// 0 and polar angles from 0 to 89 degrees, denser toward grazing. Directions without data count as 0. Parallel,
/// deterministic; about 20 ms per angle on one core with the default number of samples. @param count number of angles.
/// @param samples per integral. @throws Cancelled.
Curve albedoCurve(const Brdf& brdf, int count = 31, int samples = 1 << 14, const TaskControl& control = {});

/// The lobe for one direction of the light: values over the hemisphere of the viewer, at the nodes of a mesh of rings
/// about the normal, dense near the mirror direction.
struct LobeSurface {
  int rings = 0;                      ///< number of polar angles, from the normal to the horizon
  int sectors = 0;                    ///< number of azimuths; the last is adjacent to the first
  std::vector<Direction> directions;  ///< wo per node; sectors run fastest
  PlottedValues points;

  std::size_t index(int ring, int sector) const {
    return std::size_t(ring) * std::size_t(sectors) + std::size_t(sector % sectors);
  }
};

/// @param thetaI polar angle of the light, rad; its azimuth is pi, as in Section. @param coverage as in
/// evaluatePlotted(). Takes a few ms.
LobeSurface lobeSurface(const Brdf& brdf, double thetaI, CosineFactor cosine, const TabulatedBrdf* coverage = nullptr,
                        int rings = 64, int sectors = 96);

}  // namespace gonio::plots
