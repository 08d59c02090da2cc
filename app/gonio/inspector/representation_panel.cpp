// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/inspector/representation_panel.h"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSlider>
#include <algorithm>
#include <array>

#include "app/gonio/document/material_files.h"
#include "core/formats/code.h"
#include "core/formats/formats.h"
#include "widgets/inputs/menu_text.h"
#include "widgets/panels/fact_list.h"

namespace gonio::app {

namespace {

const QString encodeKey = QStringLiteral("encode");
constexpr std::array<std::size_t, 14> counts{16, 32, 48, 64, 96, 128, 192, 256, 262, 384, 512, 768, 1024, 2048};
constexpr std::size_t usualCount = 1024;
constexpr int encodeDelayMilliseconds = 300;

int stepOf(std::size_t count) {
  const auto nearest = std::min_element(counts.begin(), counts.end(), [count](std::size_t a, std::size_t b) {
    const auto away = [count](std::size_t one) { return one > count ? one - count : count - one; };
    return away(a) < away(b);
  });
  return int(nearest - counts.begin());
}

}  // namespace

RepresentationPanel::RepresentationPanel(Document& document, BackgroundTasks& tasks, QWidget* parent)
    : QWidget(parent),
      m_document(document),
      m_tasks(tasks),
      m_slider(new QSlider(Qt::Horizontal)),
      m_count(new QLabel),
      m_state(new QLabel),
      m_encode(new QPushButton(tr("E&ncode"))),
      m_save(new QPushButton(tr("&Save Code..."))),
      m_show(new QCheckBox(tr("Show the en&coded material"))),
      m_facts(new widgets::FactList) {
  m_slider->setRange(0, int(counts.size()) - 1);
  m_slider->setPageStep(1);
  m_slider->setTickPosition(QSlider::TicksBelow);
  m_slider->setAccessibleName(tr("Coefficients per channel"));
  m_slider->setToolTip(
      tr("Number of dictionary atoms that represent each colour channel; more atoms lower the error but need more "
         "bytes and time.\n"
         "Tongbuasirilai 2023 uses 262."));
  m_count->setMinimumWidth(fontMetrics().horizontalAdvance(QStringLiteral("00000")));
  m_count->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  m_show->setToolTip(
      tr("Shows the decoded code instead of the measurement in the preview, with the edits applied to it.\nFiles and "
         "exports still use the measurement."));
  m_encode->setToolTip(tr("Encodes the open material as a sparse code"));
  m_save->setToolTip(
      tr("Saves the code of the measurement, without edits, as a file (.code) that opens as a material"));
  connect(m_save, &QPushButton::clicked, this, &RepresentationPanel::save);
  m_state->setWordWrap(true);
  m_state->setForegroundRole(QPalette::PlaceholderText);
  auto* label = new QLabel(tr("C&oefficients"));
  label->setBuddy(m_slider);
  auto* row = new QHBoxLayout;
  row->addWidget(label);
  row->addWidget(m_slider, 1);
  row->addWidget(m_count);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addLayout(row);
  layout->addWidget(m_show);
  layout->addWidget(m_state);
  layout->addWidget(m_encode);
  layout->addWidget(m_facts);
  layout->addWidget(m_save);
  m_delay.setSingleShot(true);
  m_delay.setInterval(encodeDelayMilliseconds);
  setCoefficients(usualCount);
  connect(m_slider, &QSlider::valueChanged, this, [this] {
    m_refusal.clear();
    m_delay.start();
    refresh();
  });
  connect(&m_delay, &QTimer::timeout, this, &RepresentationPanel::request);
  connect(m_encode, &QPushButton::clicked, this, [this] {
    m_refusal.clear();
    request();
  });
  connect(m_show, &QCheckBox::toggled, this, [this] {
    request();
    Q_EMIT shownChanged();
  });
  connect(&document, &Document::materialChanged, this, [this] {
    forget();
    request();
  });
  refresh();
}

std::size_t RepresentationPanel::coefficients() const { return counts[std::size_t(m_slider->value())]; }

void RepresentationPanel::setCoefficients(std::size_t coefficients) { m_slider->setValue(stepOf(coefficients)); }

RepresentationPanel::CodePtr RepresentationPanel::shown() const { return m_show->isChecked() ? m_code : nullptr; }

bool RepresentationPanel::isWanted() const {
  return m_document.material() && m_refusal.isEmpty() && (isVisible() || m_show->isChecked()) &&
         (!m_code || m_code->coefficients != coefficients());
}

bool RepresentationPanel::isSettled() const { return !m_requested && !m_delay.isActive(); }

void RepresentationPanel::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  request();
}

void RepresentationPanel::request() {
  m_delay.stop();
  if (!isWanted()) {
    m_tasks.drop(encodeKey);
    m_requested.reset();
  } else if (m_requested != coefficients()) {
    m_requested = coefficients();
    const LoadedMaterialPtr material = m_document.material();
    m_tasks.run<MaterialCode>(
        {tr("Encoding %1").arg(widgets::spacedName(QString::fromStdString(material->material.name))), encodeKey},
        [material, count = coefficients()](const TaskControl& control) {
          return encodeMaterial(material, count, control);
        },
        [this](const MaterialCode& code) { adopt(code); }, [this](const QString& error) { stop(error); },
        [this] { stop(tr("The encoding was stopped.")); });
  }
  refresh();
}

void RepresentationPanel::adopt(const MaterialCode& code) {
  m_requested.reset();
  m_code = std::make_shared<const MaterialCode>(code);
  refresh();
  if (m_show->isChecked()) Q_EMIT shownChanged();
}

void RepresentationPanel::stop(const QString& why) {
  m_requested.reset();
  m_refusal = why;
  refresh();
}

void RepresentationPanel::forget() {
  m_tasks.drop(encodeKey);
  m_delay.stop();
  m_requested.reset();
  m_refusal.clear();
  m_code.reset();
  Q_EMIT shownChanged();
}

void RepresentationPanel::refresh() {
  m_count->setText(QString::number(coefficients()));
  const bool current = m_code && m_code->coefficients == coefficients();
  m_slider->setEnabled(m_document.material() != nullptr);
  m_encode->setVisible(!m_refusal.isEmpty());
  m_state->setText(!m_document.material() ? tr("Open a material to encode it.")
                   : !m_refusal.isEmpty() ? m_refusal
                   : m_requested          ? tr("Encoding with %1 coefficients per channel.").arg(*m_requested)
                   : !current             ? tr("Not encoded yet.")
                                          : QString());
  m_state->setVisible(!m_state->text().isEmpty());
  // Facts about a code with another number of coefficients are greyed out.
  m_facts->setEnabled(current);
  m_facts->setFacts(m_code ? codeFacts(*m_code) : std::vector<widgets::Fact>());
  m_facts->setVisible(m_code != nullptr);
  m_save->setVisible(m_code != nullptr);
  m_save->setEnabled(current);
}

void RepresentationPanel::save() {
  const QString suffix = formatSuffix(formats::codeFormat);
  Q_EMIT saveRequested({tr("Save Code"), m_document.name(), tr("Sparse codes (*%1)").arg(suffix), suffix,
                        [code = m_code](const std::filesystem::path& path, const TaskControl&) {
                          formats::writeCode(code->encoded.code, code->dictionary->id, path);
                        }});
}

}  // namespace gonio::app

#include "moc_representation_panel.cpp"
