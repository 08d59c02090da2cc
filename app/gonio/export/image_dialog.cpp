// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/export/image_dialog.h"

#include <QButtonGroup>
#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPointer>
#include <QPushButton>
#include <QRadioButton>
#include <QSettings>
#include <QVBoxLayout>
#include <cmath>

#include "app/gonio/comparison/comparison_controller.h"
#include "app/gonio/comparison/comparison_numbers.h"
#include "app/gonio/export/picture_settings.h"
#include "widgets/inputs/dialogs.h"
#include "widgets/preview/preview_widget.h"

namespace gonio::app {

FileExports::Caption comparisonCaption(const ComparisonController& comparison, const QString& material) {
  const auto sides = comparison.sides();
  const QString names =
      ComparisonController::tr("%1, %2 against %3").arg(material, comparison.name(sides[0]), comparison.name(sides[1]));
  return [names, test = comparison.subject(sides[0]),
          reference = comparison.subject(sides[1])](const TaskControl& control) {
    const ComparisonReferencePtr made = comparisonReference(reference, control.between(0, 0.5));
    const ComparisonNumbers numbers = compareSubjects(test, *made, control.between(0.5, 1));
    return ComparisonController::tr("%1: BRDF SNR %2 dB; rendered SNR %3 dB, PSNR %4 dB (comparison scene)")
        .arg(names, comparisonValue(numbers.brdfSnr), comparisonValue(numbers.renderedSnr),
             comparisonValue(numbers.renderedPsnr));
  };
}

namespace {

const QString estimateKey = QStringLiteral("image-estimate"), purpose = QStringLiteral("export"),
              settingsGroup = QStringLiteral("image/");
constexpr int estimateDelayMilliseconds = 250;
enum Source { rendered, asItIs };
enum Format { png, exr };

QString durationText(double seconds) {
  if (seconds < 1) return ImageDialog::tr("less than 1 s");
  if (seconds < 100) return ImageDialog::tr("about %1 s").arg(seconds, 0, 'g', 2);
  if (seconds < 6000) return ImageDialog::tr("about %1 min").arg(seconds / 60, 0, 'g', 2);
  return ImageDialog::tr("about %1 h").arg(seconds / 3600, 0, 'g', 2);
}

}  // namespace

ImageDialog::ImageDialog(const Parts& parts, const QString& name, QWidget* parent)
    : QDialog(parent),
      m_parts(parts),
      m_source(new QButtonGroup(this)),
      m_settings(new PictureSettings(parts.preview.size() * parts.preview.devicePixelRatioF())) {
  setWindowTitle(tr("Export Image"));
  build();
  restore(name);
  connectParts();
  showChoices();
}

ImageDialog::~ImageDialog() { m_parts.tasks.drop(estimateKey); }

void ImageDialog::build() {
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(choiceRow());
  layout->addWidget(m_settings);
  layout->addWidget(pathRow());
  m_cost = new QLabel;
  m_cost->setWordWrap(true);
  m_cost->setMinimumHeight(2 * fontMetrics().lineSpacing());
  layout->addWidget(m_cost);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
  m_export = buttons->addButton(tr("&Export"), QDialogButtonBox::AcceptRole);
  m_export->setDefault(true);
  layout->addStretch();
  layout->addWidget(buttons);
  connect(buttons, &QDialogButtonBox::accepted, this, &ImageDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
}

QWidget* ImageDialog::choiceRow() {
  auto* box = new QWidget;
  auto* rows = new QVBoxLayout(box);
  rows->setContentsMargins(0, 0, 0, 0);
  auto* render = new QRadioButton(tr("&Render the scene"));
  render->setToolTip(tr("Path-traces the scene on the CPU with the preview's camera, light and effects"));
  const qreal ratio = m_parts.preview.devicePixelRatioF();
  auto* preview = new QRadioButton(tr("The &preview as shown (%1 × %2 pixels)")
                                       .arg(int(m_parts.preview.width() * ratio))
                                       .arg(int(m_parts.preview.height() * ratio)));
  preview->setToolTip(tr("Saves the preview with its current samples; a comparison shows both materials"));
  m_labels = new QCheckBox(tr("Add &names and numbers"));
  m_labels->setToolTip(
      tr("Adds the names of the materials, the colour scale of a difference and the SNR to a comparison image"));
  auto* indented = new QHBoxLayout;
  indented->addSpacing(2 * fontMetrics().height());
  indented->addWidget(m_labels);
  m_source->addButton(render, rendered);
  m_source->addButton(preview, asItIs);
  rows->addWidget(render);
  rows->addWidget(preview);
  rows->addLayout(indented);
  return box;
}

QWidget* ImageDialog::pathRow() {
  auto* box = new QWidget;
  auto* form = new QFormLayout(box);
  form->setContentsMargins(0, 0, 0, 0);
  m_format = new QComboBox;
  m_format->addItems({tr("PNG: 8-bit sRGB, with the preview's exposure and tone map"),
                      tr("OpenEXR: 32-bit linear radiance, without exposure and tone map")});
  m_path = new QLineEdit;
  m_path->setMinimumWidth(fontMetrics().averageCharWidth() * 50);
  auto* button = new QPushButton(tr("Br&owse..."));
  button->setAutoDefault(false);
  connect(button, &QPushButton::clicked, this, &ImageDialog::browse);
  auto* row = new QHBoxLayout;
  row->addWidget(m_path, 1);
  row->addWidget(button);
  auto* label = new QLabel(tr("F&ile"));
  label->setBuddy(m_path);
  label->setMinimumWidth(m_settings->labelWidth());
  form->addRow(tr("&Format"), m_format);
  form->addRow(label, row);
  return box;
}

void ImageDialog::connectParts() {
  m_delay.setSingleShot(true);
  m_delay.setInterval(estimateDelayMilliseconds);
  connect(&m_delay, &QTimer::timeout, this, &ImageDialog::startEstimate);
  connect(m_source, &QButtonGroup::idToggled, this, &ImageDialog::showChoices);
  connect(m_settings, &PictureSettings::costChanged, this, &ImageDialog::showChoices);
  connect(m_settings, &PictureSettings::limitsChanged, this, &ImageDialog::showEstimate);
  connect(m_format, &QComboBox::currentIndexChanged, this, [this](int format) {
    const QFileInfo info(m_path->text());
    m_path->setText(info.path() + '/' + info.completeBaseName() + (format == exr ? ".exr" : ".png"));
  });
  connect(m_path, &QLineEdit::textChanged, this, &ImageDialog::showChoices);
}

void ImageDialog::restore(const QString& name) {
  const QSettings& s = m_parts.settings;
  const auto stored = [&](const char* key, const QVariant& otherwise) {
    return s.value(settingsGroup + key, otherwise);
  };
  const bool comparing = m_parts.preview.content().isComparing();
  m_source->button(comparing                                      ? asItIs
                   : stored("source", rendered).toInt() == asItIs ? asItIs
                                                                  : rendered)
      ->setChecked(true);
  m_labels->setEnabled(comparing);
  m_labels->setChecked(comparing && stored("labels", true).toBool());
  const rendering::Scene& scene = m_parts.preview.content().scene();
  m_settings->restore(s, scene.environment && scene.showEnvironment);
  const int format = stored("format", png).toInt() == exr ? exr : png;
  m_format->setCurrentIndex(format);
  const QString beside = m_parts.document.folder();
  m_path->setText(QDir(beside.isEmpty() ? widgets::dialogFolder(purpose) : beside)
                      .filePath(name + (format == exr ? ".exr" : ".png")));
}

void ImageDialog::remember() {
  QSettings& s = m_parts.settings;
  s.setValue(settingsGroup + "source", m_source->checkedId());
  if (m_labels->isEnabled()) s.setValue(settingsGroup + "labels", m_labels->isChecked());
  m_settings->remember(s);
  s.setValue(settingsGroup + "format", m_format->currentIndex());
  widgets::rememberDialogFolder(purpose, m_path->text());
}

void ImageDialog::browse() {
  const QString filters[] = {tr("PNG (*.png)"), tr("OpenEXR (*.exr)")};
  const bool both = rendersPicture();
  QFileDialog* dialog = widgets::newSaveDialog(this, tr("Export Image"), m_path->text());
  dialog->setNameFilters(both ? QStringList{filters[0], filters[1]} : QStringList{filters[0]});
  dialog->selectNameFilter(filters[m_format->currentIndex()]);
  widgets::openFileDialog(dialog, [this, dialog, both, exrFilter = filters[1]](const QString& file) {
    const QString suffix = QFileInfo(file).suffix().toLower();
    const bool isExr = both && (suffix == "exr" || (suffix != "png" && dialog->selectedNameFilter() == exrFilter));
    m_format->setCurrentIndex(isExr ? exr : png);
    m_path->setText(suffix == "png" || suffix == "exr" ? file : file + (isExr ? ".exr" : ".png"));
  });
}

bool ImageDialog::rendersPicture() const { return m_source->checkedId() == rendered; }

PictureExport ImageDialog::request() const {
  const widgets::PreviewContent& content = m_parts.preview.content();
  PictureExport picture{.path = m_path->text(),
                        .scene = content.scene(),
                        .overrides = content.overrides(),
                        .otherSlotMaterials = content.otherSlotMaterials()};
  m_settings->apply(picture);
  picture.exposure = m_parts.preview.display().exposure;
  picture.toneMap = m_parts.preview.display().toneMap;
  return picture;
}

void ImageDialog::showChoices() {
  const bool renders = rendersPicture();
  m_settings->setEnabled(renders);
  m_format->setEnabled(renders);
  if (!renders) m_format->setCurrentIndex(png);
  m_labels->setEnabled(!renders && m_parts.preview.content().isComparing());
  m_export->setEnabled(!m_path->text().isEmpty());
  m_estimate.reset();
  m_estimateError.clear();
  if (renders) m_delay.start();
  showEstimate();
}

void ImageDialog::startEstimate() {
  const Document& document = m_parts.document;
  m_parts.tasks.run<rendering::PictureEstimate>(
      {.title = tr("Estimating the rendering time"), .key = estimateKey, .live = true},
      [picture = request(), base = document.base(), edits = document.edits()](const TaskControl& control) {
        const PicturePlan planned = planPicture(picture, editing::applyEdits(base, edits), control);
        return rendering::estimatePicture(planned.scene, planned.materials, planned.plan, picture.width, picture.height,
                                          control);
      },
      [this, self = QPointer(this)](const rendering::PictureEstimate& estimate) {
        if (!self) return;
        m_estimate = estimate;
        showEstimate();
      },
      [this, self = QPointer(this)](const QString& error) {
        if (!self) return;
        m_estimateError = error;
        showEstimate();
      });
}

void ImageDialog::showEstimate() {
  if (!rendersPicture()) return m_cost->setText(QString());
  if (!m_estimateError.isEmpty()) return m_cost->setText(m_estimateError);
  if (!m_estimate) return m_cost->setText(tr("Estimating time and noise..."));
  auto [samples, limit] = m_settings->limits();
  const bool stopped = m_estimate->seconds(samples) > limit;
  if (stopped) samples = std::max(1, int(limit / m_estimate->secondsPerSample));
  const double percent = 100 * m_estimate->noise(samples);
  const QString noise = percent < 10 ? QString::number(percent, 'g', 2) : QString::number(percent, 'f', 0);
  const QString time = durationText(m_estimate->seconds(samples));
  m_cost->setText(stopped ? tr("Time %1, for about %2 samples per pixel; noise about %3 % of the mean radiance.")
                                .arg(time)
                                .arg(samples)
                                .arg(noise)
                          : tr("Time %1; noise about %2 % of the mean radiance.").arg(time, noise));
}

bool ImageDialog::mayReplace() {
  const QFileInfo info(m_path->text());
  return !info.exists() || widgets::ask(this, tr("Replace file"), tr("Replace %1?").arg(info.fileName()));
}

void ImageDialog::exportPreview() {
  widgets::PreviewWidget& preview = m_parts.preview;
  const QString path = m_path->text();
  if (!m_labels->isEnabled() || !m_labels->isChecked()) return m_parts.exports.writePng(path, preview.grabPicture());
  m_parts.exports.writePng(path, preview.grabLabelledPicture(),
                           comparisonCaption(m_parts.comparison, m_parts.document.name()));
}

void ImageDialog::accept() {
  const QString wanted = m_format->currentIndex() == exr ? ".exr" : ".png";
  if (!m_path->text().endsWith(wanted, Qt::CaseInsensitive)) m_path->setText(m_path->text() + wanted);
  if (m_parts.exports.refuses(m_path->text()) || !mayReplace()) return;
  m_parts.tasks.drop(estimateKey);
  remember();
  if (rendersPicture())
    m_parts.exports.renderPicture(request());
  else
    exportPreview();
  QDialog::accept();
}

}  // namespace gonio::app

#include "moc_image_dialog.cpp"
