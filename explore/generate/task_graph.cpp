#include "explore/generate/task_graph.hpp"

#include "explore/generate/statements.hpp"
#include "text/counted.hpp"
#include "text/load_source.hpp"
#include "text/nearest.hpp"
#include "text/number.hpp"
#include "text/refused_text.hpp"
#include "text/table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <sstream>
#include <vector>

namespace placedpar::generate {

namespace {

constexpr std::size_t most_tasks = 100'000;
constexpr std::size_t most_faults = 20;

struct Message {
    std::size_t to;
    std::string bytes;
};

struct Task {
    std::string name; ///< name of its process
    std::string cycles;
    std::size_t processor = 0;
    std::vector<Message> messages = {};
};

class TaskTable {
public:
    TaskTable(const std::string& path, std::size_t processors) : processors_(processors) {
        load(path);
        find_columns();
        for (const TextRow& row : table_.rows)
            add_name(row, row.cells[task_]);
        refuse_if_faulty();
        for (const TextRow& row : table_.rows)
            tasks_.push_back(task_of(row));
        require_order();
        refuse_if_faulty();
    }

    const std::vector<Task>& tasks() const { return tasks_; }

private:
    void load(const std::string& path) {
        LoadedSource loaded = load_input(path);
        file_ = loaded.file;
        faults_ = std::move(loaded.problems);
        refuse_if_faulty();
        table_ = split_table(file_->text(), faults_);
        if (table_.header.cells.empty() || table_.rows.empty() || table_.rows.size() > most_tasks)
            faults_.push_back(error_at(0, 0, fmt::format("expected a header and 1 to {} tasks", most_tasks),
                                       "the columns are task, cycles, successors and processor"));
        refuse_if_faulty();
    }

    void refuse_if_faulty() {
        if (faults_.empty())
            return;
        for (Diagnostic& each : faults_)
            each.location.file = file_;
        faults_.resize(std::min(faults_.size(), most_faults));
        throw RefusedText(faults_);
    }

    /// Adds a fault. Refuses the table at once if it has many faults, because the search for similar names takes long.
    void fault(const TextRow& row, const TextCell& cell, std::string message, std::string hint) {
        faults_.push_back(error_at(row.line, cell.column, std::move(message), std::move(hint)));
        if (faults_.size() >= most_faults)
            refuse_if_faulty();
    }

    void add_name(const TextRow& row, const TextCell& cell) {
        constexpr std::string_view allowed = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_";
        if (cell.text.empty() || cell.text.size() > 60 || cell.text.find_first_not_of(allowed) != std::string::npos)
            fault(row, cell, fmt::format("\"{}\" cannot be the name of a task", cell.text),
                  "a name has 1 to 60 letters, digits and underscores");
        if (!numbers_.emplace(cell.text, numbers_.size()).second)
            fault(row, cell, fmt::format("the task \"{}\" is listed twice", cell.text), "give each task its own name");
    }

    /// Returns the index of a column; the number of columns if no column has this name.
    std::size_t column(std::string_view name) const {
        const auto& cells = table_.header.cells;
        return static_cast<std::size_t>(std::ranges::find(cells, name, &TextCell::text) - cells.begin());
    }

    void find_columns() {
        task_ = column("task"), cycles_ = column("cycles"), successors_ = column("successors");
        processor_ = column("processor");
        for (const char* name : {"task", "cycles", "successors"})
            if (column(name) == table_.header.cells.size())
                faults_.push_back(error_at(table_.header.line, 1, fmt::format("the table has no column \"{}\"", name),
                                           "the columns are task, cycles, successors and, optionally, processor"));
        refuse_if_faulty();
    }

    Task task_of(const TextRow& row) {
        const TextCell& cycles = row.cells[cycles_];
        if (const auto number = parse_number<std::uint64_t>(cycles.text); !number || *number > 1'000'000'000'000)
            fault(row, cycles, fmt::format("\"{}\" is not a number of cycles", cycles.text),
                  "give a whole number up to 1e12");
        Task task{
            .name = "task_" + row.cells[task_].text, .cycles = cycles.text, .processor = tasks_.size() % processors_};
        if (processor_ < row.cells.size() && !row.cells[processor_].text.empty())
            task.processor = processor_in(row, row.cells[processor_]);
        std::istringstream successors(row.cells[successors_].text);
        for (std::string word; successors >> word;)
            add_message(task, row, word);
        return task;
    }

    std::size_t processor_in(const TextRow& row, const TextCell& cell) {
        const auto number = parse_number<std::size_t>(cell.text);
        if (!number || *number >= processors_)
            fault(row, cell, fmt::format("\"{}\" is not a processor of this machine", cell.text),
                  fmt::format("the processors are 0 to {}", processors_ - 1));
        return number.value_or(0);
    }

    /// Adds the message that a successor such as "b:100" describes: 100 bytes to the task b.
    void add_message(Task& task, const TextRow& row, const std::string& word) {
        const std::size_t colon = word.rfind(':');
        const std::string name = word.substr(0, colon), bytes = colon == word.npos ? "" : word.substr(colon + 1);
        const auto length = parse_number<std::uint32_t>(bytes);
        const TextCell& cell = row.cells[successors_];
        if (!length || *length == 0 || *length > 1'000'000'000)
            return fault(row, cell, fmt::format("\"{}\" does not state a number of bytes", word),
                         "a successor is written NAME:BYTES, with 1 to 1000000000 bytes");
        const auto found = numbers_.find(name);
        if (found == numbers_.end()) {
            std::vector<std::string> names;
            for (const auto& each : numbers_)
                names.push_back(each.first);
            return fault(row, cell, unknown_name("task", name, names, "a successor must be a task of the table"), "");
        }
        task.messages.push_back({found->second, bytes});
    }

    /// Reports tasks in a circle, because they would wait for each other for ever.
    void require_order() {
        std::vector<std::size_t> waits_for(tasks_.size()), ready;
        for (const Task& task : tasks_)
            for (const Message& message : task.messages)
                ++waits_for[message.to];
        for (std::size_t i = 0; i < tasks_.size(); ++i)
            if (waits_for[i] == 0)
                ready.push_back(i);
        for (std::size_t next = 0; next < ready.size(); ++next)
            for (const Message& message : tasks_[ready[next]].messages)
                if (--waits_for[message.to] == 0)
                    ready.push_back(message.to);
        if (ready.size() == tasks_.size())
            return;
        const auto stuck = static_cast<std::size_t>(
            std::ranges::find_if(waits_for, [](std::size_t left) { return left > 0; }) - waits_for.begin());
        const TextRow& row = table_.rows[stuck];
        fault(row, row.cells[task_],
              fmt::format("the task \"{}\" is in a circle of tasks, or depends on one", row.cells[task_].text),
              "remove a successor: a task graph cannot have circles");
    }

    std::size_t processors_;
    std::shared_ptr<const SourceFile> file_;
    TextTable table_;
    std::vector<Diagnostic> faults_;
    std::size_t task_ = 0, cycles_ = 0, successors_ = 0, processor_ = 0; ///< indices of the columns
    std::map<std::string, std::size_t> numbers_;
    std::vector<Task> tasks_;
};

} // namespace

Job tasks_of_file(const std::string& path, std::size_t processors, const Topology& topology) {
    const TaskTable table(path, processors);
    const auto& tasks = table.tasks();
    std::string processes, channels, places;
    std::vector<std::size_t> inputs(tasks.size());
    for (const Task& task : tasks) {
        std::vector<std::string> bytes;
        for (const Message& message : task.messages) {
            channels += fmt::format("connect {}.out[{}] to {}.in[{}];\n", task.name, bytes.size(),
                                    tasks[message.to].name, inputs[message.to]++);
            bytes.push_back(message.bytes);
        }
        processes += fmt::format("process {0};\nuse \"csp.task\" for {0};\n{0} (cycles = {1}, bytes = \"{2}\");\n",
                                 task.name, task.cycles, fmt::join(bytes, " "));
        places += within({fmt::format("rep i = {} for 1", task.processor)},
                         {fmt::format("place {} on t{};", task.name, topology.at)});
    }
    return {.about = fmt::format("A graph of {} from {}.", counted(tasks.size(), "task"), path),
            .vals = "",
            .statements = processes + channels + places};
}

} // namespace placedpar::generate
