// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

namespace gonio::widgets {

/// Decides how many samples a frame takes and at which scale, from the measured cost of the frames before: interaction
/// stays fluid, rest converges. Plain arithmetic, no OpenGL.
class FrameBudget {
 public:
  static constexpr double interactiveMs = 30;
  static constexpr double restingMs = 80;
  static constexpr int maxSamplesPerFrame = 64;
  /// Below this many samples the first frame is drawn at half the resolution instead; at a quarter of it where a sample
  /// at half takes longer than this.
  static constexpr int minFirstSamples = 6;
  static constexpr double longestFirstMs = 100;

  struct Frame {
    int samples;
    double scale;  ///< of the resolution: 1, 0.5 or 0.25
  };
  /// @param pixels of the picture at full scale; @param accumulated samples so far (0: first frame after a change);
  /// @param wanted samples of the converged picture; @param resting nothing has changed for a while.
  Frame next(double pixels, int accumulated, int wanted, bool resting) const;

  /// Takes in what a frame cost.
  void record(double pixels, int samples, double milliseconds);

 private:
  double nsPerSample_ = 15;
};

}  // namespace gonio::widgets
