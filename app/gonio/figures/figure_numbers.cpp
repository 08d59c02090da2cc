// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/figures/figure_numbers.h"

#include <QApplication>
#include <QLabel>
#include <QListWidget>
#include <QSignalBlocker>
#include <QStyledItemDelegate>
#include <QVBoxLayout>
#include <algorithm>

#include "core/figures/figure_description.h"
#include "core/metrics/brdf_metric.h"
#include "core/metrics/image_errors.h"
#include "widgets/inputs/plain_text_style.h"
#include "widgets/parameters/formula_text.h"
#include "widgets/parameters/parameter_text.h"

namespace gonio::app {

namespace {

constexpr int shownNumbers = 5;

QString toolTipOf(const figures::FigureNumber& number) {
  for (const metrics::ImageMetricRecord& record : metrics::imageMetricRecords())
    if (record.id == number.id) return widgets::metricToolTip(record.formula, record.reference);
  for (const metrics::MetricRecord& record : metrics::metricRecords())
    if (record.id == number.id) return widgets::metricToolTip(record.formula, record.reference);
  if (number.isTimed) return FigureNumbersList::tr("Measured on this machine; differs from run to run");
  return number.id == "bytes" ? FigureNumbersList::tr("Size of the stored representation, bytes")
                              : FigureNumbersList::tr("SNR of the images in the figure, without their rendering noise");
}

QString textOf(const figures::FigureNumber& number) {
  for (const metrics::MetricRecord& record : metrics::metricRecords())
    if (record.id == number.id) return FigureNumbersList::tr("BRDF metric: %1").arg(widgets::toQString(record.name));
  for (const metrics::ImageMetricRecord& record : metrics::imageMetricRecords())
    if (record.id == number.id) return FigureNumbersList::tr("Image metric: %1").arg(widgets::toQString(record.name));
  if (number.isTimed) return FigureNumbersList::tr("Time: %1").arg(QString::fromStdString(number.name));
  return number.id == "bytes" ? FigureNumbersList::tr("Size") : FigureNumbersList::tr("Rendered SNR");
}

/// Draws the boxes in the colours of check boxes, which are visible in the dark theme too (theme.h).
class TickDelegate : public QStyledItemDelegate {
 public:
  using QStyledItemDelegate::QStyledItemDelegate;

 protected:
  void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override {
    QStyledItemDelegate::initStyleOption(option, index);
    option->palette.setColor(QPalette::Base, QApplication::palette("QCheckBox").color(QPalette::Base));
  }
};

}  // namespace

FigureNumbersList::FigureNumbersList(QWidget* parent) : QWidget(parent), m_list(new QListWidget), m_order(new QLabel) {
  m_list->setItemDelegate(new TickDelegate(m_list));
  m_list->setAccessibleName(tr("Numbers"));
  m_list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  m_list->setMinimumHeight((shownNumbers + 1) * fontMetrics().lineSpacing());
  for (const figures::FigureNumber& number : figures::figureNumbers()) {
    auto* item = new QListWidgetItem(textOf(number), m_list);
    item->setData(widgets::richToolTipRole, toolTipOf(number));
  }
  m_order->setWordWrap(true);
  m_order->setForegroundRole(QPalette::PlaceholderText);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(m_list, 1);
  layout->addWidget(m_order);
  connect(m_list, &QListWidget::itemChanged, this,
          [this](const QListWidgetItem* item) { take(m_list->row(item), item->checkState() == Qt::Checked); });
  show();
}

void FigureNumbersList::setNumbers(std::vector<std::string> numbers) {
  m_numbers = std::move(numbers);
  show();
}

void FigureNumbersList::take(int row, bool isTicked) {
  const std::string& id = figures::figureNumbers()[std::size_t(row)].id;
  const bool isIn = std::ranges::count(m_numbers, id) > 0;
  if (isIn == isTicked) return;
  if (isTicked)
    m_numbers.push_back(id);
  else
    std::erase(m_numbers, id);
  show();
  Q_EMIT changed();
}

void FigureNumbersList::show() {
  const QSignalBlocker quiet(m_list);
  const bool full = m_numbers.size() >= figures::FigureDescription::maxNumbers;
  for (int row = 0; row < m_list->count(); ++row) {
    const bool isIn = std::ranges::count(m_numbers, figures::figureNumbers()[std::size_t(row)].id) > 0;
    QListWidgetItem* item = m_list->item(row);
    item->setCheckState(isIn ? Qt::Checked : Qt::Unchecked);
    const Qt::ItemFlags flags = Qt::ItemIsSelectable | Qt::ItemIsUserCheckable;
    item->setFlags(full && !isIn ? flags : flags | Qt::ItemIsEnabled);
  }
  QStringList names;
  for (const std::string& id : m_numbers) names << QString::fromStdString(figures::figureNumber(id).name);
  m_order->setText(names.isEmpty() ? tr("No numbers")
                   : full          ? tr("%1 (maximum reached)").arg(names.join(QStringLiteral(", ")))
                                   : names.join(QStringLiteral(", ")));
}

}  // namespace gonio::app

#include "moc_figure_numbers.cpp"
