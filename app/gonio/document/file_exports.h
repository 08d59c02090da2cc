// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QColor>
#include <QObject>
#include <QString>
#include <filesystem>
#include <functional>

#include "app/gonio/document/background_task.h"
#include "app/gonio/document/document.h"
#include "core/materials/material_formats.h"
#include "core/rendering/picture_refinement.h"
#include "core/rendering/tone_map.h"
#include "core/support/task_control.h"

namespace gonio::app {

/// Something other than the material that a panel shows and that can be saved as a file: factors, a code, a fit.
struct FileSave {
  QString title;   ///< title of the dialog, e.g. "Save Factors"
  QString name;    ///< proposed file name, without folder and suffix
  QString filter;  ///< "PDV factors (*.pdv)"
  QString suffix;  ///< ".pdv"
  /// Not for the GUI thread. @throws Error that names the file; Cancelled.
  std::function<void(const std::filesystem::path& path, const TaskControl& control)> write;
};

/// The background of a written picture.
enum class PictureBackground { environment, transparent, colour };

/// A picture to be rendered and written: content, size, quality and format.
struct PictureExport {
  QString path;  ///< its suffix decides: `.exr` 32-bit linear radiance, else 8-bit sRGB PNG
  rendering::Scene scene;
  rendering::EffectOverrides overrides;
  rendering::RenderMaterials otherSlotMaterials;  ///< from slot 1 on, see materialsInSlots()
  int width = 1024, height = 1024;
  rendering::RefinementLimits limits;
  PictureBackground background = PictureBackground::transparent;
  QColor colour = Qt::black;  ///< of the background; its linear value in an EXR
  double exposure = 0;        ///< stops; PNG only
  rendering::ToneMap toneMap = rendering::ToneMap::filmic;

  bool isExr() const { return path.endsWith(QStringLiteral(".exr"), Qt::CaseInsensitive); }
  /// The scene with the picture's background.
  rendering::Scene shownScene() const;
};

/// Input of the path tracer.
struct PicturePlan {
  rendering::Scene scene;
  rendering::RenderMaterials materials;
  rendering::EffectPlan plan;
};
PicturePlan planPicture(const PictureExport& request, const std::shared_ptr<const Brdf>& edited,
                        const TaskControl& control);

/// Renders a picture and writes it atomically. Not for the GUI thread.
/// @param edited the document's material with its edits, named `name`. @throws Error that names the file; Cancelled.
void writeRenderedPicture(const PictureExport& request, const std::shared_ptr<const Brdf>& edited,
                          const std::string& name, const TaskControl& control, const Pause& pause);

/// Composes an image over a colour. The bytes are sRGB with straight alpha, mixed in linear light; the resulting alpha
/// is 255.
void composeOver(const QColor& colour, std::span<std::uint8_t> rgba);
/// The same for linear radiance; the image then has no alpha.
void composeOver(const QColor& colour, Image& image);

/// Writes the document's material and pictures of it to files in the background, one after the other. Never replaces
/// the files that the document uses.
class FileExports : public QObject {
  Q_OBJECT

 public:
  FileExports(Document& document, BackgroundTasks& tasks, QObject* parent = nullptr);

  /// Whether a file is used by the document; if so, emits failed().
  bool refuses(const QString& path);
  /// Writes the edited material in a format. If content is lost, emits lossesFound() before anything is written.
  void writeMaterial(const QString& path, const materials::MaterialFormat& format);
  /// Renders the edited material on the CPU; the user can pause it.
  void renderPicture(const PictureExport& picture);
  /// Writes what another panel saves (factors, a code, a fit, a figure) with FileSave::write, in the background.
  void save(const QString& path, const FileSave& save);
  /// Called in the background.
  using Caption = std::function<QString(const TaskControl&)>;
  /// Writes a picture unchanged, with 8 bits per channel. @param caption text of a line below it.
  void writePng(const QString& path, const QImage& picture, const Caption& caption = {});

 Q_SIGNALS:
  void exported(const QString& path);
  void failed(const QString& title, const QString& text);
  /// What a file of the material would lose, with its measured error. Nothing is written unless `write` is called.
  void lossesFound(const QString& path, const QString& text, const std::function<void()>& write);
  /// The user cancelled; nothing was written.
  void cancelled(const QString& path);

 private:
  using FileBytes = std::shared_ptr<const std::vector<std::byte>>;
  void writeBytes(const QString& path, const FileBytes& bytes);
  template <class Result>
  void run(const QString& title, const QString& path, std::function<Result(const TaskControl&)> work,
           std::function<void(const Result&)> done, const std::shared_ptr<Pause>& pause = nullptr);

  Document& m_document;
  BackgroundTasks& m_tasks;
};

}  // namespace gonio::app
