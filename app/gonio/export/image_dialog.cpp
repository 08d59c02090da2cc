// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/export/image_dialog.h"

#include <QButtonGroup>
#include <QCheckBox>
#include <QColorDialog>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QPointer>
#include <QPushButton>
#include <QRadioButton>
#include <QSettings>
#include <QSpinBox>
#include <QVBoxLayout>
#include <cmath>

#include "app/gonio/comparison/comparison_controller.h"
#include "app/gonio/export/labelled_picture.h"
#include "widgets/inputs/dialog_folder.h"
#include "widgets/preview/preview_widget.h"

namespace gonio::app {

namespace {

const QString estimateKey = QStringLiteral("image-estimate"), purpose = QStringLiteral("export"),
              settingsGroup = QStringLiteral("image/");
constexpr int estimateDelayMilliseconds = 250, mostPixelsOfSide = 8192, mostSamples = 1 << 20, mostSeconds = 86'400;
enum Source { rendered, asItIs };
enum Format { png, exr };

/// Sizes that are offered; that of the preview comes first.
constexpr QSize offeredSizes[] = {{1024, 1024}, {2048, 2048}, {1920, 1080}, {3840, 2160}};

QString durationText(double seconds) {
  if (seconds < 1) return ImageDialog::tr("less than 1 s");
  if (seconds < 100) return ImageDialog::tr("about %1 s").arg(seconds, 0, 'g', 2);
  if (seconds < 6000) return ImageDialog::tr("about %1 min").arg(seconds / 60, 0, 'g', 2);
  return ImageDialog::tr("about %1 h").arg(seconds / 3600, 0, 'g', 2);
}

QSpinBox* countField(int most, const QString& unit = {}) {
  auto* field = new QSpinBox;
  field->setRange(1, most);
  field->setSuffix(unit);
  field->setGroupSeparatorShown(true);
  return field;
}

}  // namespace

ImageDialog::ImageDialog(const Parts& parts, const QString& name, QWidget* parent)
    : QDialog(parent), m_parts(parts), m_source(new QButtonGroup(this)) {
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
  layout->addWidget(m_page = renderedPage());
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
  render->setToolTip(tr("By path tracing on the processor, with the preview's camera, light and effects"));
  const qreal ratio = m_parts.preview.devicePixelRatioF();
  auto* preview = new QRadioButton(tr("The &preview as it is (%1 x %2 pixels)")
                                       .arg(int(m_parts.preview.width() * ratio))
                                       .arg(int(m_parts.preview.height() * ratio)));
  preview->setToolTip(tr("With the samples that it has now, and in a comparison both materials"));
  m_labels = new QCheckBox(tr("With &names, scale and numbers"));
  m_labels->setToolTip(tr("Of a comparison: what is shown, the legend of a difference, and the SNR below the picture"));
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

QWidget* ImageDialog::renderedPage() {
  auto* page = new QWidget;
  auto* form = new QFormLayout(page);
  form->setContentsMargins(0, 0, 0, 0);
  form->addRow(tr("&Size"), sizeRow());
  form->addRow(tr("S&amples"), qualityRows());
  m_backgrounds = new QComboBox;
  m_backgrounds->addItems({tr("Environment"), tr("Transparent (alpha)"), tr("Colour")});
  m_colourButton = new QPushButton;
  m_colourButton->setAutoDefault(false);
  m_colourButton->setAccessibleName(tr("Colour of the background"));
  auto* row = new QHBoxLayout;
  row->addWidget(m_backgrounds, 1);
  row->addWidget(m_colourButton);
  auto* label = new QLabel(tr("&Background"));
  label->setBuddy(m_backgrounds);
  form->addRow(label, row);
  return page;
}

QWidget* ImageDialog::sizeRow() {
  auto* box = new QWidget;
  auto* row = new QHBoxLayout(box);
  row->setContentsMargins(0, 0, 0, 0);
  m_sizes = new QComboBox;
  m_sizes->addItem(tr("As the preview"));
  for (const QSize& size : offeredSizes)
    m_sizes->addItem(QStringLiteral("%1 x %2").arg(size.width()).arg(size.height()));
  m_sizes->addItem(tr("Other"));
  m_width = countField(mostPixelsOfSide);
  m_height = countField(mostPixelsOfSide);
  m_width->setAccessibleName(tr("Width in pixels"));
  m_height->setAccessibleName(tr("Height in pixels"));
  row->addWidget(m_sizes, 1);
  row->addWidget(m_width);
  row->addWidget(new QLabel(QStringLiteral("x")));
  row->addWidget(m_height);
  box->setFocusProxy(m_sizes);
  return box;
}

QWidget* ImageDialog::qualityRows() {
  auto* box = new QWidget;
  auto* row = new QHBoxLayout(box);
  row->setContentsMargins(0, 0, 0, 0);
  m_samples = countField(mostSamples, tr(" a pixel"));
  m_samples->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
  m_limited = new QCheckBox(tr("Stop &after"));
  m_limited->setToolTip(tr("The picture is written with the samples that it has by then"));
  m_seconds = countField(mostSeconds, tr(" s"));
  m_seconds->setAccessibleName(tr("Longest time in seconds"));
  row->addWidget(m_samples, 1);
  row->addWidget(m_limited);
  row->addWidget(m_seconds);
  box->setFocusProxy(m_samples);
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
  form->addRow(tr("&Format"), m_format);
  form->addRow(label, row);
  return box;
}

void ImageDialog::connectParts() {
  m_delay.setSingleShot(true);
  m_delay.setInterval(estimateDelayMilliseconds);
  connect(&m_delay, &QTimer::timeout, this, &ImageDialog::startEstimate);
  connect(m_source, &QButtonGroup::idToggled, this, &ImageDialog::showChoices);
  connect(m_sizes, &QComboBox::activated, this, &ImageDialog::chooseSize);
  for (QSpinBox* side : {m_width, m_height})
    connect(side, &QSpinBox::valueChanged, this, [this] {
      showSize();
      showChoices();
    });
  connect(m_samples, &QSpinBox::valueChanged, this, &ImageDialog::showEstimate);
  connect(m_seconds, &QSpinBox::valueChanged, this, &ImageDialog::showEstimate);
  connect(m_limited, &QCheckBox::toggled, this, &ImageDialog::showChoices);
  connect(m_backgrounds, &QComboBox::currentIndexChanged, this, &ImageDialog::showChoices);
  connect(m_colourButton, &QPushButton::clicked, this, &ImageDialog::chooseColour);
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
  const bool comparing = m_parts.preview.isComparing();
  m_source->button(comparing                                      ? asItIs
                   : stored("source", rendered).toInt() == asItIs ? asItIs
                                                                  : rendered)
      ->setChecked(true);
  m_labels->setEnabled(comparing);
  m_labels->setChecked(comparing && stored("labels", true).toBool());
  m_width->setValue(stored("width", 1024).toInt());
  m_height->setValue(stored("height", 1024).toInt());
  showSize();
  m_samples->setValue(stored("samples", 256).toInt());
  m_limited->setChecked(stored("limited", false).toBool());
  m_seconds->setValue(stored("seconds", 60).toInt());
  m_colour = QColor(stored("colour", "#3a3a3c").toString());
  const Scene& scene = m_parts.preview.scene();
  const PictureBackground background = scene.environment && scene.showEnvironment ? PictureBackground::environment
                                       : stored("transparent", true).toBool()     ? PictureBackground::transparent
                                                                                  : PictureBackground::colour;
  m_backgrounds->setCurrentIndex(int(background));
  const int format = stored("format", png).toInt() == exr ? exr : png;
  m_format->setCurrentIndex(format);
  m_path->setText(widgets::inDialogFolder(purpose, name + (format == exr ? ".exr" : ".png")));
}

void ImageDialog::remember() {
  QSettings& s = m_parts.settings;
  s.setValue(settingsGroup + "source", m_source->checkedId());
  if (m_labels->isEnabled()) s.setValue(settingsGroup + "labels", m_labels->isChecked());
  s.setValue(settingsGroup + "width", m_width->value());
  s.setValue(settingsGroup + "height", m_height->value());
  s.setValue(settingsGroup + "samples", m_samples->value());
  s.setValue(settingsGroup + "limited", m_limited->isChecked());
  s.setValue(settingsGroup + "seconds", m_seconds->value());
  s.setValue(settingsGroup + "colour", m_colour.name());
  s.setValue(settingsGroup + "transparent", m_backgrounds->currentIndex() != int(PictureBackground::colour));
  s.setValue(settingsGroup + "format", m_format->currentIndex());
  widgets::rememberDialogFolder(purpose, m_path->text());
}

void ImageDialog::chooseSize(int preset) {
  if (preset > int(std::size(offeredSizes))) return m_width->setFocus();
  const QSize size = preset == 0 ? m_parts.preview.size() : offeredSizes[preset - 1];
  m_width->setValue(size.width());
  m_height->setValue(size.height());
}

void ImageDialog::showSize() {
  const QSize size(m_width->value(), m_height->value());
  const auto* found = std::ranges::find(offeredSizes, size);
  m_sizes->setCurrentIndex(size == m_parts.preview.size() ? 0 : 1 + int(found - std::begin(offeredSizes)));
}

void ImageDialog::chooseColour() {
  const QColor colour = QColorDialog::getColor(m_colour, this, tr("Colour of the background"));
  if (!colour.isValid()) return;
  m_colour = colour;
  showChoices();
}

void ImageDialog::browse() {
  const QString filters[] = {tr("PNG (*.png)"), tr("OpenEXR (*.exr)")};
  QString chosen = filters[m_format->currentIndex()];
  const bool both = rendersPicture();
  const QString file = QFileDialog::getSaveFileName(this, tr("Export Image"), m_path->text(),
                                                    both ? filters[0] + ";;" + filters[1] : filters[0], &chosen,
                                                    QFileDialog::DontConfirmOverwrite);
  if (file.isEmpty()) return;
  const QString suffix = QFileInfo(file).suffix().toLower();
  const bool isExr = both && (suffix == "exr" || (suffix != "png" && chosen == filters[1]));
  m_format->setCurrentIndex(isExr ? exr : png);
  m_path->setText(suffix == "png" || suffix == "exr" ? file : file + (isExr ? ".exr" : ".png"));
}

bool ImageDialog::rendersPicture() const { return m_source->checkedId() == rendered; }

PictureExport ImageDialog::request() const {
  const widgets::PreviewWidget& preview = m_parts.preview;
  PictureExport picture{.path = m_path->text(),
                        .scene = preview.scene(),
                        .overrides = preview.overrides(),
                        .others = preview.others(),
                        .width = m_width->value(),
                        .height = m_height->value()};
  picture.limits.samples = m_samples->value();
  if (m_limited->isChecked()) picture.limits.seconds = m_seconds->value();
  picture.background = PictureBackground(m_backgrounds->currentIndex());
  picture.colour = m_colour;
  picture.exposure = preview.exposure();
  picture.toneMap = preview.toneMap();
  return picture;
}

void ImageDialog::showChoices() {
  const bool renders = rendersPicture();
  m_page->setEnabled(renders);
  m_format->setEnabled(renders);
  if (!renders) m_format->setCurrentIndex(png);
  m_labels->setEnabled(!renders && m_parts.preview.isComparing());
  m_seconds->setEnabled(m_limited->isChecked());
  m_colourButton->setVisible(m_backgrounds->currentIndex() == int(PictureBackground::colour));
  m_colourButton->setText(m_colour.name());
  QPixmap swatch(fontMetrics().height(), fontMetrics().height());
  swatch.fill(m_colour);
  m_colourButton->setIcon(swatch);
  m_export->setEnabled(!m_path->text().isEmpty());
  m_estimate.reset();
  m_estimateError.clear();
  if (renders) m_delay.start();
  showEstimate();
}

void ImageDialog::startEstimate() {
  const Document& document = m_parts.document;
  m_parts.tasks.run<PictureEstimate>(
      {.title = tr("Estimating the time of a picture"), .key = estimateKey, .live = true},
      [picture = request(), base = document.base(), edits = document.edits()](const TaskControl& control) {
        const PicturePlan planned = planPicture(picture, editing::applyEdits(base, edits));
        return estimatePicture(planned.scene, planned.materials, planned.plan, picture.width, picture.height, control);
      },
      [this, self = QPointer(this)](const PictureEstimate& estimate) {
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
  int samples = m_samples->value();
  const double limit = m_seconds->value();
  const bool stopped = m_limited->isChecked() && m_estimate->seconds(samples) > limit;
  if (stopped) samples = std::max(1, int(limit / m_estimate->secondsOfSample));
  const QString noise = QString::number(100 * m_estimate->noise(samples), 'g', 2);
  const QString time = durationText(m_estimate->seconds(samples));
  m_cost->setText(stopped ? tr("Time %1, for about %2 samples a pixel; noise about %3 % of the mean radiance.")
                                .arg(time)
                                .arg(samples)
                                .arg(noise)
                          : tr("Time %1; noise about %2 % of the mean radiance.").arg(time, noise));
}

bool ImageDialog::mayReplace() {
  const QFileInfo info(m_path->text());
  return !info.exists() || QMessageBox::question(this, tr("Replace file"), tr("Replace %1?").arg(info.fileName()),
                                                 QMessageBox::Yes | QMessageBox::No) == QMessageBox::Yes;
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
