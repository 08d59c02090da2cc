// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/factors/factor_terms_view.h"

#include <QLabel>
#include <QPainter>
#include <QSlider>
#include <QVBoxLayout>

#include "core/formats/pdv.h"
#include "core/study/study_record.h"
#include "widgets/charts/plot_style.h"

namespace gonio::app {

FactorsWithCosts factorizeWithCosts(const LoadedMaterialPtr& material, const FactorsWithCosts::Kind& kind,
                                    const TaskControl& control) {
  FactorsWithCosts measured;
  measured.material = material;
  const auto table = material->table(control);
  measured.factorization = factorization::factorizePdv(
      *table, {.form = kind.form, .transform = kind.transform, .terms = maxEditedTerms}, control);
  measured.along = factorization::residualsAlong(*table, measured.factorization.factors,
                                                 factorization::PdvOptions().weights, control);
  for (int terms = 1; terms <= measured.factorization.factors.terms(); ++terms) {
    control.throwIfStopped();
    const auto factors = measured.factorization.factors.truncated(terms);
    measured.bytes.push_back(formats::pdvFileBytes(factors));
    measured.nanoseconds.push_back(study::measureEvaluation(*factorization::makePdvBrdf(factors)).median);
  }
  return measured;
}

/// The residuals over the terms, from 0 to that of the first term and a little more.
class FactorTermsView::Chart : public QWidget {
 public:
  explicit Chart(const FactorTermsView& view) : m_view(view) {
    setMinimumHeight(5 * fontMetrics().height());
    setAccessibleName(tr("Residual vs. number of terms"));
  }

 protected:
  void paintEvent(QPaintEvent*) override {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const widgets::PlotStyle style = widgets::PlotStyle::of(palette());
    painter.fillRect(rect(), style.background);
    if (!m_view.m_measured) return;
    const double line = fontMetrics().height();
    const QRectF area(0.6 * line, 1.5 * line, width() - 1.2 * line, height() - 3 * line);
    const FactorsWithCosts& measured = *m_view.m_measured;
    const int count = int(measured.bytes.size());
    const double highest = std::max(1e-9, measured.residual(1) * 1.1);
    const auto at = [&](int terms) {
      return QPointF(area.left() + area.width() * (terms - 1) / std::max(1, count - 1),
                     area.bottom() - area.height() * measured.residual(terms) / highest);
    };
    painter.setPen(style.text);
    painter.drawText(QRectF(4, 2, width() - 8.0, line), Qt::AlignLeft, tr("Residual [%] vs. terms"));
    painter.drawLine(area.bottomLeft(), area.bottomRight());
    for (int terms = 1; terms <= count; ++terms) {
      const bool chosen = terms == m_view.terms();
      const QPointF point = at(terms);
      painter.setPen(QPen(style.text, 1.5));
      if (terms > 1) painter.drawLine(at(terms - 1), point);
      painter.setBrush(chosen ? style.accent : style.background);
      painter.drawEllipse(point, chosen ? 5 : 3.5, chosen ? 5 : 3.5);
      painter.drawText(QRectF(point.x() - line, area.bottom() + 2, 2 * line, line), Qt::AlignCenter,
                       QString::number(terms));
    }
  }

 private:
  const FactorTermsView& m_view;
};

FactorTermsView::FactorTermsView(QWidget* parent)
    : QWidget(parent), m_chart(new Chart(*this)), m_slider(new QSlider(Qt::Horizontal)), m_text(new QLabel) {
  m_slider->setRange(1, maxEditedTerms);
  m_slider->setPageStep(1);
  m_slider->setTickPosition(QSlider::TicksBelow);
  m_slider->setAccessibleName(tr("Number of terms"));
  m_slider->setToolTip(
      tr("Number of products of curves that are summed; more terms lower the residual. The curves shown are those\n"
         "of the first term; the others represent its residual. Dragging a point changes only the first term;\n"
         "the buttons below a curve change it in all terms."));
  m_text->setWordWrap(true);
  m_text->setTextInteractionFlags(Qt::TextSelectableByMouse);
  auto* label = new QLabel(tr("&Terms"));
  label->setBuddy(m_slider);
  auto* row = new QHBoxLayout;
  row->addWidget(label);
  row->addWidget(m_slider, 1);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(m_chart, 1);
  layout->addLayout(row);
  layout->addWidget(m_text);
  connect(m_slider, &QSlider::valueChanged, this, [this](int terms) {
    refresh();
    Q_EMIT termsChosen(terms);
  });
  refresh();
}

void FactorTermsView::setMeasured(std::shared_ptr<const FactorsWithCosts> measured) {
  m_measured = std::move(measured);
  refresh();
}

void FactorTermsView::setTerms(int terms) {
  const QSignalBlocker blocker(m_slider);
  m_slider->setValue(terms);
  refresh();
}

int FactorTermsView::terms() const { return m_slider->value(); }

void FactorTermsView::refresh() {
  m_slider->setEnabled(m_measured != nullptr);
  if (m_measured) {
    const auto at = std::size_t(terms() - 1);
    m_text->setText(tr("Residual %1 %, %2 kB, %3 ns per evaluation (on this machine)")
                        .arg(100 * m_measured->residual(terms()), 0, 'f', 1)
                        .arg(double(m_measured->bytes[at]) / 1000, 0, 'f', 1)
                        .arg(m_measured->nanoseconds[at], 0, 'f', 0));
  } else {
    m_text->setText(tr("Not measured yet"));
  }
  m_chart->update();
}

}  // namespace gonio::app

#include "moc_factor_terms_view.cpp"
