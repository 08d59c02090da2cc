// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <functional>

#include "core/math/image.h"
#include "core/rendering/render_picture.h"
#include "core/rendering/rendered_comparison.h"
#include "core/study/representation_builder.h"
#include "core/study/study_record.h"

namespace gonio::study {

/// A representation as it was measured, with what was measured.
struct StudiedRepresentation {
  StudyRecord record;
  std::shared_ptr<const Brdf> brdf;
  Image picture;  ///< in the study's scene, linear RGB
  std::function<std::shared_ptr<const TabulatedBrdf>(const TaskControl&)> tabulated;  ///< see BuiltRepresentation
  std::optional<fitting::FitResult> fit;                                              ///< see BuiltRepresentation
};

struct StudyOptions {
  BuildOptions build;
  /// Of the pictures and of the frames that are timed; the lobe is the reference's.
  RenderOptions picture = smallComparisonPicture();
  /// Of the pictures instead of comparisonScene(): the rendered SNRs are then those of this scene.
  std::optional<Scene> scene = {};
  /// Whether the times of an evaluation and of a frame are measured; without them one frame is rendered.
  bool timed = true;
  /// Called after each representation, in their order, on the calling thread.
  std::function<void(const StudiedRepresentation&)> measured = {};
  /// Called before them with the picture of the reference.
  std::function<void(const Image&)> referenceRendered = {};
};

/// Makes representations of one material and measures each: errors by every metric, rendered SNR, bytes, and times of
/// this machine now (of encoding, of an evaluation, of a frame: the median of three, of fewer where they take more than
/// a second). Errors leave out the angles that `build.fit` leaves out. Deterministic but for the times. About two
/// seconds a representation on two cores.
/// @return a record a representation, in their order. A stop request returns the records that are done; it never
/// throws Cancelled.
/// @throws Error as RepresentationBuilder::build.
std::vector<StudyRecord> runStudy(const StudySubject& subject, std::span<const Representation> representations,
                                  const StudyOptions& options = {}, const TaskControl& control = {});

}  // namespace gonio::study
