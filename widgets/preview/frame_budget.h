// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

namespace gonio::widgets {

/// Chooses the number of samples and the scale of a frame from the measured cost of previous frames, so that
/// interaction stays fluid and a picture at rest converges quickly. Plain arithmetic, no OpenGL.
class FrameBudget {
 public:
  static constexpr double interactiveMs = 30;
  static constexpr double restingMs = 80;
  static constexpr int maxSamplesPerFrame = 64;
  /// If the time allows fewer samples than this, the first frame has half the resolution; if one sample at half
  /// resolution takes longer than maxFirstFrameMs, a quarter.
  static constexpr int minFirstSamples = 6;
  static constexpr double maxFirstFrameMs = 100;

  struct Frame {
    int samples;
    double scale;  ///< of the resolution: 1, 0.5 or 0.25
  };
  /// @param pixels of the picture at full scale; @param accumulated samples so far (0: first frame after a change);
  /// @param wanted samples of the converged picture; @param resting nothing has changed for a while.
  Frame next(double pixels, int accumulated, int wanted, bool resting) const;

  /// Records the cost of a frame.
  void record(double pixels, int samples, double milliseconds);

 private:
  double nsPerSample_ = 15;
};

}  // namespace gonio::widgets
