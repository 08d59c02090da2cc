// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/export/picture_settings.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QSettings>
#include <QSpinBox>
#include <algorithm>

#include "widgets/parameters/colour_picker.h"

namespace gonio::app {

namespace {

constexpr int maxPixelsOfSide = 8192, maxSamples = 1 << 20, maxSeconds = 86'400;
const QString pictureSettingsGroup = QStringLiteral("image/");

/// Sizes that are offered; that of the preview comes first.
constexpr QSize offeredSizes[] = {{1024, 1024}, {2048, 2048}, {1920, 1080}, {3840, 2160}};

QSpinBox* countField(int most, const QString& unit = {}) {
  auto* field = new QSpinBox;
  field->setRange(1, most);
  field->setSuffix(unit);
  field->setGroupSeparatorShown(true);
  return field;
}

}  // namespace

PictureSettings::PictureSettings(const QSize& preview, QWidget* parent) : QWidget(parent), m_preview(preview) {
  auto* form = new QFormLayout(this);
  form->setContentsMargins(0, 0, 0, 0);
  // The keys of the labels give the first field of a row the focus.
  const auto addRow = [form](const QString& text, auto* row, QWidget* first) {
    auto* label = new QLabel(text);
    label->setBuddy(first);
    form->addRow(label, row);
  };
  QWidget* size = sizeRow();
  addRow(tr("&Size"), size, m_sizes);
  QWidget* quality = qualityRow();
  addRow(tr("Sa&mples"), quality, m_samples);
  m_backgrounds = new QComboBox;
  m_backgrounds->addItems({tr("Environment"), tr("Transparent (alpha)"), tr("Colour")});
  m_colourButton = new QPushButton;
  m_colourButton->setAutoDefault(false);
  m_colourButton->setAccessibleName(tr("Background colour"));
  auto* row = new QHBoxLayout;
  row->addWidget(m_backgrounds, 1);
  row->addWidget(m_colourButton);
  addRow(tr("&Background"), row, m_backgrounds);
  connectParts();
}

QWidget* PictureSettings::sizeRow() {
  auto* box = new QWidget;
  auto* row = new QHBoxLayout(box);
  row->setContentsMargins(0, 0, 0, 0);
  m_sizes = new QComboBox;
  m_sizes->addItem(tr("As in preview"));
  for (const QSize& size : offeredSizes)
    m_sizes->addItem(QStringLiteral("%1 × %2").arg(size.width()).arg(size.height()));
  m_sizes->addItem(tr("Other"));
  m_width = countField(maxPixelsOfSide);
  m_height = countField(maxPixelsOfSide);
  m_width->setAccessibleName(tr("Width in pixels"));
  m_height->setAccessibleName(tr("Height in pixels"));
  row->addWidget(m_sizes, 1);
  row->addWidget(m_width);
  row->addWidget(new QLabel(QStringLiteral("x")));
  row->addWidget(m_height);
  return box;
}

QWidget* PictureSettings::qualityRow() {
  auto* box = new QWidget;
  auto* row = new QHBoxLayout(box);
  row->setContentsMargins(0, 0, 0, 0);
  m_samples = countField(maxSamples, tr(" per pixel"));
  m_samples->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
  m_limited = new QCheckBox(tr("Stop &after"));
  m_limited->setToolTip(tr("Stops rendering after this time and saves the image with the samples rendered so far"));
  m_seconds = countField(maxSeconds, tr(" s"));
  m_seconds->setAccessibleName(tr("Max. time in seconds"));
  row->addWidget(m_samples, 1);
  row->addWidget(m_limited);
  row->addWidget(m_seconds);
  return box;
}

void PictureSettings::chooseSize(int preset) {
  if (preset > int(std::size(offeredSizes))) return m_width->setFocus();
  const QSize size = preset == 0 ? m_preview : offeredSizes[preset - 1];
  m_width->setValue(size.width());
  m_height->setValue(size.height());
}

void PictureSettings::showSize() {
  const QSize size(m_width->value(), m_height->value());
  const auto* found = std::ranges::find(offeredSizes, size);
  m_sizes->setCurrentIndex(size == m_preview ? 0 : 1 + int(found - std::begin(offeredSizes)));
}

void PictureSettings::chooseColour() {
  auto* dialog = new widgets::ColourPicker(m_colour, this);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setWindowTitle(tr("Background colour"));
  connect(dialog, &QDialog::accepted, this, [this, dialog] {
    m_colour = dialog->colour();
    showChoices();
  });
  dialog->open();
}

void PictureSettings::connectParts() {
  connect(m_sizes, &QComboBox::activated, this, &PictureSettings::chooseSize);
  for (QSpinBox* length : {m_width, m_height})
    connect(length, &QSpinBox::valueChanged, this, [this] {
      showSize();
      Q_EMIT costChanged();
    });
  for (QSpinBox* limit : {m_samples, m_seconds})
    connect(limit, &QSpinBox::valueChanged, this, &PictureSettings::limitsChanged);
  connect(m_limited, &QCheckBox::toggled, this, [this] {
    showChoices();
    Q_EMIT limitsChanged();
  });
  connect(m_backgrounds, &QComboBox::currentIndexChanged, this, [this] {
    showChoices();
    Q_EMIT costChanged();
  });
  connect(m_colourButton, &QPushButton::clicked, this, &PictureSettings::chooseColour);
}

void PictureSettings::showChoices() {
  m_seconds->setEnabled(m_limited->isChecked());
  m_colourButton->setVisible(m_backgrounds->currentIndex() == int(PictureBackground::colour));
  m_colourButton->setText(m_colour.name());
  QPixmap swatch(fontMetrics().height(), fontMetrics().height());
  swatch.fill(m_colour);
  m_colourButton->setIcon(swatch);
}

void PictureSettings::restore(const QSettings& settings, bool environmentShown) {
  const auto stored = [&](const char* key, const QVariant& otherwise) {
    return settings.value(pictureSettingsGroup + key, otherwise);
  };
  m_width->setValue(stored("width", 1024).toInt());
  m_height->setValue(stored("height", 1024).toInt());
  showSize();
  m_samples->setValue(stored("samples", 256).toInt());
  m_limited->setChecked(stored("limited", false).toBool());
  m_seconds->setValue(stored("seconds", 60).toInt());
  m_colour = QColor(stored("colour", "#3a3a3c").toString());
  m_backgrounds->setCurrentIndex(int(environmentShown                       ? PictureBackground::environment
                                     : stored("transparent", true).toBool() ? PictureBackground::transparent
                                                                            : PictureBackground::colour));
  showChoices();
}

void PictureSettings::remember(QSettings& settings) const {
  const auto store = [&](const char* key, const QVariant& value) {
    settings.setValue(pictureSettingsGroup + key, value);
  };
  store("width", m_width->value());
  store("height", m_height->value());
  store("samples", m_samples->value());
  store("limited", m_limited->isChecked());
  store("seconds", m_seconds->value());
  store("colour", m_colour.name());
  store("transparent", m_backgrounds->currentIndex() != int(PictureBackground::colour));
}

rendering::RefinementLimits PictureSettings::limits() const {
  rendering::RefinementLimits limits{.samples = m_samples->value()};
  if (m_limited->isChecked()) limits.seconds = m_seconds->value();
  return limits;
}

int PictureSettings::labelWidth() const {
  int widest = 0;
  const auto& form = *qobject_cast<QFormLayout*>(layout());
  for (int row = 0; row < form.rowCount(); ++row)
    widest = std::max(widest, form.itemAt(row, QFormLayout::LabelRole)->widget()->sizeHint().width());
  return widest;
}

void PictureSettings::apply(PictureExport& picture) const {
  picture.width = m_width->value();
  picture.height = m_height->value();
  picture.limits = limits();
  picture.background = PictureBackground(m_backgrounds->currentIndex());
  picture.colour = m_colour;
}

}  // namespace gonio::app

#include "moc_picture_settings.cpp"
