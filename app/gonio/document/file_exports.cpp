// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/document/file_exports.h"

#include <QFileInfo>
#include <QImage>
#include <QPainter>
#include <QTimer>
#include <cmath>

#include "core/documents/blend_source.h"
#include "core/io/atomic_file.h"
#include "core/io/image_io.h"
#include "core/materials/encode.h"
#include "core/rendering/plan_check.h"
#include "core/support/error.h"

namespace gonio::app {

namespace {

Rgb linearOf(const QColor& colour) {
  return {fromSrgb(colour.redF()), fromSrgb(colour.greenF()), fromSrgb(colour.blueF())};
}

}  // namespace

rendering::Scene PictureExport::shownScene() const {
  rendering::Scene shown = scene;
  shown.showEnvironment = background == PictureBackground::environment;
  return shown;
}

PicturePlan planPicture(const PictureExport& request, const std::shared_ptr<const Brdf>& edited,
                        const TaskControl& control) {
  PicturePlan planned{.scene = request.shownScene()};
  const auto material = std::make_shared<const rendering::RenderMaterial>(edited);
  planned.materials = rendering::bindMaterials(
      planned.scene, rendering::materialsInSlots(planned.scene, material, request.otherSlotMaterials));
  planned.plan = rendering::checkedPlan(planned.scene, planned.materials, request.overrides, {}, {control.stop, {}});
  return planned;
}

void writeRenderedPicture(const PictureExport& request, const std::shared_ptr<const Brdf>& edited,
                          const std::string& name, const TaskControl& control, const Pause& pause) {
  constexpr std::uint64_t seed = 1;
  const PicturePlan planned = planPicture(request, edited, control);
  const rendering::PathTracer tracer(planned.scene, planned.materials, planned.plan, seed);
  rendering::Film film(request.width, request.height);
  rendering::refinePicture(tracer, film, request.limits, control, &pause);
  Image image = film.image();
  const bool overColour = request.background == PictureBackground::colour;
  const std::string path = request.path.toStdString();
  if (request.isExr()) {
    if (overColour) composeOver(request.colour, image);
    return io::writeExr(image, path,
                        rendering::pictureAttributes(planned.scene, planned.plan, name, film.samples, seed));
  }
  std::vector<std::uint8_t> bytes = rendering::toDisplayBytes(image, request.exposure, request.toneMap);
  if (overColour) composeOver(request.colour, bytes);
  io::writePng(bytes, image.width, image.height, path);
}

void composeOver(const QColor& colour, std::span<std::uint8_t> rgba) {
  const Rgb behind = linearOf(colour);
  for (std::size_t i = 0; i + 3 < rgba.size(); i += 4) {
    const double alpha = rgba[i + 3] / 255.0;
    if (alpha == 1) continue;
    for (int c = 0; c < 3; ++c) {
      std::uint8_t& byte = rgba[i + std::size_t(c)];
      byte = std::uint8_t(std::lround(255 * toSrgb(alpha * fromSrgb(byte / 255.0) + (1 - alpha) * behind[c])));
    }
    rgba[i + 3] = 255;
  }
}

void composeOver(const QColor& colour, Image& image) {
  const Rgb behind = linearOf(colour);
  for (std::size_t i = 0; i < image.alpha.size(); ++i) image.pixels[i] += glm::vec3(behind * (1.0 - image.alpha[i]));
  image.alpha.clear();
}

namespace {

/// The picture with a line of text below it, broken where it is too long.
QImage withCaption(const QImage& picture, const QString& text) {
  QFont font;
  font.setPixelSize(std::max(11, picture.width() / 70));
  const int margin = font.pixelSize() / 2;
  const QRect room(margin, picture.height() + margin, picture.width() - 2 * margin, picture.height());
  const QRect place = QFontMetrics(font).boundingRect(room, Qt::TextWordWrap, text);
  QImage whole(picture.width(), place.bottom() + margin, QImage::Format_RGB32);
  whole.fill(Qt::black);
  QPainter painter(&whole);
  QImage own = picture;
  own.setDevicePixelRatio(1);
  painter.drawImage(0, 0, own);
  painter.setFont(font);
  painter.setPen(Qt::white);
  painter.drawText(room, Qt::TextWordWrap, text);
  return whole;
}

QString nameOf(const QString& path) { return path.section('/', -1); }

/// What a file lost, for the user; empty if nothing.
QString lossText(const materials::Encoded& made, const materials::MaterialFormat& format) {
  QStringList lines;
  for (const std::string& loss : made.losses) lines << QString::fromStdString(loss);
  if (lines.isEmpty() && !std::isfinite(made.snr)) return {};
  lines << (std::isfinite(made.snr) ? FileExports::tr("rendered SNR of the file %1 dB, BRDF SNR %2 dB")
                                          .arg(made.snr, 0, 'f', 1)
                                          .arg(made.brdfSnr, 0, 'f', 1)
                                    : FileExports::tr("images of the file and of the material are identical"));
  if (const std::string text = materials::shortfall(made, format, {}); !text.empty())
    lines.back() = QString::fromStdString(text);
  return lines.join(QStringLiteral(";\n")) + '.';
}

}  // namespace

FileExports::FileExports(Document& document, BackgroundTasks& tasks, QObject* parent)
    : QObject(parent), m_document(document), m_tasks(tasks) {}

bool FileExports::refuses(const QString& path) {
  if (!io::isOneOf(path.toStdString(), documents::sourceFiles(m_document.toEditDocument()))) return false;
  Q_EMIT failed(tr("Cannot write %1").arg(nameOf(path)),
                tr("%1 is a measured file that this document edits. Choose another name.").arg(path));
  return true;
}

template <class Result>
void FileExports::run(const QString& title, const QString& path, std::function<Result(const TaskControl&)> work,
                      std::function<void(const Result&)> done, const std::shared_ptr<Pause>& pause) {
  m_tasks.run<Result>(
      {.title = title.arg(nameOf(path)), .file = true, .pause = pause}, std::move(work), std::move(done),
      [this, path](const QString& error) { Q_EMIT failed(tr("Cannot export %1").arg(nameOf(path)), error); },
      [this, path] { Q_EMIT cancelled(path); });
}

void FileExports::writeMaterial(const QString& path, const materials::MaterialFormat& format) {
  if (!m_document.material() || refuses(path)) return;
  run<materials::Encoded>(
      tr("Exporting %1"), path,
      [edited = m_document.edited(), &format, path](const TaskControl& control) {
        materials::Encoded made =
            withFileInErrors(path.toStdString(), [&] { return materials::encode(edited, format, {}, control); });
        if (lossText(made, format).isEmpty()) io::writeFileAtomically(path.toStdString(), made.bytes);
        return made;
      },
      [this, &format, path](const materials::Encoded& made) {
        const QString text = lossText(made, format);
        if (text.isEmpty()) return Q_EMIT exported(path);
        const auto bytes = std::make_shared<const std::vector<std::byte>>(made.bytes);
        // Once this task is no longer shown as running: the answer may take a while.
        QTimer::singleShot(0, this, [this, path, text, bytes] {
          Q_EMIT lossesFound(path, text, [this, path, bytes] { writeBytes(path, bytes); });
        });
      });
}

void FileExports::writeBytes(const QString& path, const FileBytes& bytes) {
  if (refuses(path)) return;  // the document may have changed before the answer
  run<bool>(
      tr("Writing %1"), path,
      [path, bytes](const TaskControl&) {
        io::writeFileAtomically(path.toStdString(), *bytes);
        return true;
      },
      [this, path](bool) { Q_EMIT exported(path); });
}

void FileExports::renderPicture(const PictureExport& picture) {
  const LoadedMaterialPtr material = m_document.material();
  if (!material || refuses(picture.path)) return;
  const auto pause = std::make_shared<Pause>();
  run<bool>(
      tr("Rendering %1"), picture.path,
      [material, base = m_document.base(), edits = m_document.edits(), picture, pause](const TaskControl& control) {
        writeRenderedPicture(picture, editing::applyEdits(base, edits), material->material.name, control, *pause);
        return true;
      },
      [this, path = picture.path](bool) { Q_EMIT exported(path); }, pause);
}

void FileExports::save(const QString& path, const FileSave& save) {
  if (refuses(path)) return;
  run<bool>(
      tr("Writing %1"), path,
      [write = save.write, path](const TaskControl& control) {
        write(path.toStdString(), control);
        return true;
      },
      [this, path](bool) { Q_EMIT exported(path); });
}

void FileExports::writePng(const QString& path, const QImage& picture, const Caption& caption) {
  if (refuses(path)) return;
  run<bool>(
      tr("Writing %1"), path,
      [picture, path, caption](const TaskControl& control) {
        const QImage whole = caption ? withCaption(picture, caption(control)) : picture;
        const QImage rgba = whole.convertToFormat(QImage::Format_RGBA8888);
        std::vector<unsigned char> bytes;
        for (int y = 0; y < rgba.height(); ++y)
          bytes.insert(bytes.end(), rgba.constScanLine(y), rgba.constScanLine(y) + 4 * rgba.width());
        io::writePng(bytes, rgba.width(), rgba.height(), path.toStdString());
        return true;
      },
      [this, path](bool) { Q_EMIT exported(path); });
}

}  // namespace gonio::app

#include "moc_file_exports.cpp"
