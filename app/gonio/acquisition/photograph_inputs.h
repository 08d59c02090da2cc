// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QImage>
#include <QSize>
#include <QString>
#include <QStringList>
#include <nlohmann/json.hpp>
#include <vector>

#include "core/matching/sphere_finder.h"
#include "core/math/colour.h"
#include "core/math/image.h"
#include "core/support/task_control.h"

namespace gonio::app {

/// The place of a camera about the middle of the surface. Azimuths are from +z toward +x, as of OrbitCamera.
struct PhotographCamera {
  double distance = 4;                ///< radii
  double azimuth = 0, elevation = 0;  ///< rad
  bool operator==(const PhotographCamera&) const = default;
};

/// The light of a photograph: one environment, one distant light, or other lights, which only a description states.
struct PhotographLight {
  enum class Kind { environment, distant, other };
  Kind kind = Kind::environment;
  QString environment = QStringLiteral("studio");  ///< a bundled name, or a file
  double rotation = 0;                             ///< rad
  double azimuth = 0, elevation = 0;               ///< toward the distant light, rad
  double irradiance = 0;                           ///< of the distant light, mean of the channels
  bool operator==(const PhotographLight&) const = default;
};

/// A photograph as the panel holds it: its entry in the description, with absolute paths, and its image for display.
// Moving JSON throws nothing. NOLINTNEXTLINE(bugprone-exception-escape)
struct PhotographItem {
  nlohmann::json entry;            ///< member of "images" in a description (docs/photographs.md)
  nlohmann::json describedLights;  ///< "lights" as they were read
  QImage shown;                    ///< at most shownSide pixels per side
  QSize size;                      ///< of the image file, pixels
  double brightness = 1;           ///< factor of the radiance in `shown`
  bool isOutlineFound = true;      ///< or stated, or there is none; otherwise it is a circle in the middle

  static constexpr int shownSide = 1200;

  QString path() const;
  QString name() const { return path().section('/', -1); }
  /// Whether it shows a sphere. The shapes of a description are not edited.
  bool hasOutline() const { return !entry.contains("shape"); }
  /// The outline of a sphere; for other shapes a circle around the image.
  matching::Disc disc() const;
  void setDisc(const matching::Disc& disc);
  PhotographCamera camera() const;
  void setCamera(const PhotographCamera& camera);
  PhotographLight light() const;
  /// Other lights are those that were read.
  void setLight(const PhotographLight& light);
};

/// Photographs of one material, as a description that is edited. Members of a description that the panel does not show
/// stay as they are.
class PhotographInputs {
 public:
  const std::vector<PhotographItem>& items() const { return m_items; }
  bool isEmpty() const { return m_items.empty(); }
  std::size_t size() const { return m_items.size(); }
  PhotographItem& operator[](std::size_t index) { return m_items[index]; }
  const PhotographItem& operator[](std::size_t index) const { return m_items[index]; }
  void add(std::vector<PhotographItem> items);
  void remove(std::size_t index);
  bool isExposureKnown() const;
  void setExposureKnown(bool known);

  /// The description as JSON text. @param folder to which paths of files in it are relative; empty: all are absolute.
  std::string description(const QString& folder = {}) const;

 private:
  friend PhotographInputs readPhotographDescription(const QString& path, const TaskControl& control);
  nlohmann::json m_root = nlohmann::json::object();  ///< members beside "images"
  std::vector<PhotographItem> m_items;
};

/// Reads a description with its images. @throws Error as photograph::readDescription(); Cancelled.
PhotographInputs readPhotographDescription(const QString& path, const TaskControl& control = {});

/// Reads images and finds their spheres. @param like an entry of a description, of which shape, camera and lights are
/// copied; null: a sphere, the default camera and the environment "studio". @throws Error that names the file;
/// Cancelled.
std::vector<PhotographItem> readPhotographs(const QStringList& paths, const nlohmann::json& like,
                                            const TaskControl& control = {});

/// Finds the outline of the sphere in the file of a photograph. @throws Error that names the file if there is none.
matching::Disc findOutline(const PhotographItem& item);

/// Whether a file is a photograph or a description, by its suffix. A PNG or JPEG image is one, so that the error says
/// what is wrong with it.
bool isPhotographFile(const QString& path);
bool isPhotographDescription(const QString& path);

/// Display colours of radiance, without a tone curve. @param factor of the radiance.
QImage photographColours(const Image& radiance, double factor);

}  // namespace gonio::app
