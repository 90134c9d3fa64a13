#include "problems/benchmark/tour_file.hpp"

#include "problems/benchmark/tours.hpp"
#include "text/load_source.hpp"
#include "text/nearest.hpp"
#include "text/number.hpp"
#include "text/user_error.hpp"

#include <boost/algorithm/string/trim.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>

namespace placedpar {

namespace {

constexpr std::size_t most_cities = 5000;

using Distance = double (*)(const City&, const City&);

double euclidean(const City& a, const City& b) { return std::hypot(a.x - b.x, a.y - b.y); }

double nearest_whole(const City& a, const City& b) { return std::floor(euclidean(a, b) + 0.5); }

double next_whole(const City& a, const City& b) { return std::ceil(euclidean(a, b)); }

/// Returns the pseudo-Euclidean distance: the root of a tenth of the squared distance, rounded up to a whole number.
double pseudo_euclidean(const City& a, const City& b) {
    const double exact = euclidean(a, b) / std::sqrt(10.0), whole = std::floor(exact + 0.5);
    return whole < exact ? whole + 1 : whole;
}

/// Returns the angle in radians of a coordinate DDD.MM, in degrees and minutes. TSPLIB fixes the value of pi.
double radians(double coordinate) {
    const double degrees = std::trunc(coordinate);
    return 3.141592 * (degrees + 5 * (coordinate - degrees) / 3) / 180;
}

/// Returns the distance of two cities on a sphere with TSPLIB's radius of the earth; x is the latitude, y the
/// longitude.
double geographical(const City& a, const City& b) {
    constexpr double radius_km = 6378.388;
    const double along = std::cos(radians(a.y) - radians(b.y)), difference = std::cos(radians(a.x) - radians(b.x));
    const double sum = std::cos(radians(a.x) + radians(b.x));
    return std::trunc(radius_km * std::acos(0.5 * ((1 + along) * difference - (1 - along) * sum)) + 1);
}

const std::map<std::string, Distance>& distances_by_type() {
    static const std::map<std::string, Distance> all{{"ATT", pseudo_euclidean},
                                                     {"CEIL_2D", next_whole},
                                                     {"EUC_2D", nearest_whole},
                                                     {"EXPLICIT", nullptr},
                                                     {"GEO", geographical}};
    return all;
}

/// Says which part of a row of an explicit matrix is in the file.
struct MatrixForm {
    bool lower, upper, diagonal;

    bool has(std::size_t row, std::size_t column) const {
        return row == column ? diagonal : column < row ? lower : upper;
    }
};

const std::map<std::string, MatrixForm>& matrix_forms() {
    static const std::map<std::string, MatrixForm> all{{"FULL_MATRIX", {true, true, true}},
                                                       {"LOWER_DIAG_ROW", {true, false, true}},
                                                       {"LOWER_ROW", {true, false, false}},
                                                       {"UPPER_DIAG_ROW", {false, true, true}},
                                                       {"UPPER_ROW", {false, true, false}}};
    return all;
}

class TourFile {
public:
    explicit TourFile(const std::filesystem::path& path) : path_(path) {
        LoadedSource source = load_source(path);
        if (!source.problems.empty())
            throw UserError(fmt::format("{}: {}", path.string(), source.problems.front().message));
        text_.str(std::string(source.file->text()));
    }

    TableTour read() {
        std::string line;
        while (next(line) && line != "EOF")
            if (const auto colon = line.find(':'); colon != line.npos && !line.ends_with("_SECTION:"))
                specify(boost::algorithm::trim_copy(line.substr(0, colon)),
                        boost::algorithm::trim_copy(line.substr(colon + 1)));
            else
                read_section(line.substr(0, colon));
        if (distances_.empty())
            refuse("the file ends without cities: expected NODE_COORD_SECTION or EDGE_WEIGHT_SECTION");
        return TableTour(cities_, std::move(distances_));
    }

private:
    [[noreturn]] void refuse(const std::string& message) const {
        throw UserError(fmt::format("{}:{}: {}", path_.string(), number_, message));
    }

    /// Reads the next line that is not empty, without blanks around it.
    bool next(std::string& line) {
        while (std::getline(text_, line)) {
            ++number_;
            boost::algorithm::trim(line);
            if (!line.empty())
                return true;
        }
        return false;
    }

    template <class Value>
    const Value& choice(const std::map<std::string, Value>& all, const std::string& name,
                        const std::string& key) const {
        if (const auto found = all.find(name); found != all.end())
            return found->second;
        std::vector<std::string> names;
        for (const auto& [each, value] : all)
            names.push_back(each);
        refuse(fmt::format("{}: \"{}\" cannot be read: expected {}", key, name, fmt::join(names, ", ")));
    }

    /// Throws UserError if this keyword or section has occurred before.
    void require_first(const std::string& name) {
        if (name != "COMMENT" && !seen_.insert(name).second)
            refuse(fmt::format("\"{}\" occurs twice, expected once", name));
    }

    void specify(const std::string& key, const std::string& value) {
        require_first(key);
        static const std::array ignored{"NAME", "COMMENT", "NODE_COORD_TYPE", "DISPLAY_DATA_TYPE"};
        if (key == "TYPE")
            may_be_asymmetric_ = choice<bool>({{"ATSP", true}, {"TSP", false}}, value.substr(0, value.find(' ')), key);
        else if (key == "DIMENSION")
            cities_ = parse_number<std::size_t>(value).value_or(0);
        else if (key == "EDGE_WEIGHT_TYPE")
            distance_ = choice(distances_by_type(), value, key);
        else if (key == "EDGE_WEIGHT_FORMAT")
            form_ = value == "FUNCTION" ? std::nullopt : std::optional(choice(matrix_forms(), value, key));
        else if (std::ranges::count(ignored, key) == 0)
            refuse(fmt::format("unknown keyword \"{}\"", key));
        if (key == "DIMENSION" && (cities_ < 1 || cities_ > most_cities))
            refuse(fmt::format("DIMENSION: \"{}\" is not a number of cities from 1 to {}", value, most_cities));
    }

    void read_section(const std::string& name) {
        require_first(name);
        if (cities_ == 0)
            refuse(fmt::format("DIMENSION is missing before \"{}\"", name));
        if (!distances_.empty() && name != "DISPLAY_DATA_SECTION")
            refuse(fmt::format("\"{}\" is one section too many: an earlier section has given all distances", name));
        if (name == "NODE_COORD_SECTION")
            take_coordinates(read_coordinates());
        else if (name == "EDGE_WEIGHT_SECTION")
            read_matrix();
        else if (name == "DISPLAY_DATA_SECTION")
            read_coordinates();
        else
            refuse(fmt::format("\"{}\" cannot be read: expected a line such as \"DIMENSION: 52\", NODE_COORD_SECTION, "
                               "EDGE_WEIGHT_SECTION or EOF",
                               name));
    }

    std::vector<City> read_coordinates() {
        std::vector<std::optional<City>> found(cities_);
        for (std::size_t i = 0; i < cities_; ++i) {
            std::string line;
            std::size_t city = 0;
            City place;
            if (!next(line))
                refuse(fmt::format("the file ends after {} of {} cities", i, cities_));
            std::istringstream words(line);
            if (!(words >> city >> place.x >> place.y) || !(words >> std::ws).eof() || city < 1 || city > cities_)
                refuse(fmt::format("expected a city from 1 to {} and its two coordinates, not \"{}\"", cities_, line));
            if (found[city - 1])
                refuse(fmt::format("city {} has coordinates twice, expected once", city));
            found[city - 1] = place;
        }
        text_ >> std::ws;
        if (std::isdigit(text_.peek()))
            refuse(fmt::format("after this line follow more cities than \"DIMENSION: {}\" says", cities_));
        std::vector<City> all;
        for (const auto& each : found)
            all.push_back(*each);
        return all;
    }

    void take_coordinates(const std::vector<City>& cities) {
        if (!distance_)
            refuse("NODE_COORD_SECTION needs an EDGE_WEIGHT_TYPE before it that computes distances, such as EUC_2D");
        for (const City& from : cities)
            for (const City& to : cities)
                add(&from == &to ? 0 : distance_(from, to));
    }

    void add(double distance) {
        if (!(distance >= 0 && distance <= std::numeric_limits<std::int32_t>::max()))
            refuse(fmt::format("the distance {} is not a number from 0 to 2^31 - 1", distance));
        distances_.push_back(static_cast<std::int32_t>(distance));
    }

    void read_matrix() {
        if (!form_)
            refuse("EDGE_WEIGHT_SECTION needs an EDGE_WEIGHT_FORMAT before it, such as FULL_MATRIX");
        distances_.assign(cities_ * cities_, 0);
        for (std::size_t row = 0; row < cities_; ++row)
            for (std::size_t column = 0; column < cities_; ++column)
                if (form_->has(row, column)) {
                    const std::int32_t distance = next_weight();
                    distances_[row * cities_ + column] = distance;
                    if (!(form_->lower && form_->upper))
                        distances_[column * cities_ + row] = distance;
                }
        if (weights_ >> std::ws && !weights_.eof())
            refuse("the line has more distances than the format and DIMENSION allow");
        text_ >> std::ws;
        if (std::isdigit(text_.peek()))
            refuse("after this line follow more distances than the format and DIMENSION allow");
        if (!may_be_asymmetric_)
            require_symmetry();
    }

    void require_symmetry() const {
        for (std::size_t row = 0; row < cities_; ++row)
            for (std::size_t column = 0; column < row; ++column) {
                const std::int32_t there = distances_[row * cities_ + column],
                                   back = distances_[column * cities_ + row];
                if (there != back)
                    refuse(
                        fmt::format("the distance from city {} to city {} is {}, but {} in the other direction; write "
                                    "\"TYPE: ATSP\" if that is right",
                                    row + 1, column + 1, there, back));
            }
    }

    std::int32_t next_weight() {
        std::string word;
        while (!(weights_ >> word)) {
            std::string line;
            if (!next(line) || line == "EOF")
                refuse("the matrix has fewer distances than the format and DIMENSION need");
            weights_ = std::istringstream(line);
        }
        const auto weight = parse_number<std::int32_t>(word);
        if (!weight || *weight < 0)
            refuse(fmt::format("\"{}\" is not a distance: expected a whole number from 0 to 2^31 - 1", word));
        return *weight;
    }

    std::filesystem::path path_;
    std::istringstream text_, weights_; ///< the whole file; the current line of a matrix
    std::size_t number_ = 0;            ///< number of the current line
    std::size_t cities_ = 0;
    std::set<std::string> seen_;     ///< keywords and sections read so far
    bool may_be_asymmetric_ = false; ///< the type is ATSP
    Distance distance_ = nullptr;
    std::optional<MatrixForm> form_;
    std::vector<std::int32_t> distances_;
};

} // namespace

double TableTour::objective(std::span<const std::size_t> order) const {
    double length = 0;
    for (std::size_t i = 0; i < order.size(); ++i)
        length += distances_[order[i] * places_ + order[(i + 1) % order.size()]];
    return length;
}

TableTour read_tour_file(const std::filesystem::path& path) { return TourFile(path).read(); }

} // namespace placedpar
