#pragma once

#include "serve/examples.hpp"
#include "serve/runs.hpp"
#include "web/server.hpp"

#include <boost/json/fwd.hpp>

#include <cstdint>
#include <string>

namespace placedpar::serve {

/// The web site on which users run netlists and programs in occam. "/" is the page; "/examples", "/exercises" and
/// "/catalogue" are its data. A POST to "/job?NAME" contains a job (serve/answer.hpp) with the page's files. The reply
/// is the job's answer. "/place?NAME" returns the position of that job in the queue. "/healthz" needs no token; all
/// other paths do.
class Site {
public:
    /// `keep` is the folder in which jobs are stored, except checks of a program's text. If it is "", no jobs are
    /// stored.
    Site(Runs& runs, Texts examples, std::string keep);

    /// Answers a request, at once or later. Returns a function that withdraws the request's job (see
    /// web::Server::Handler).
    web::Withdraw answer(const web::Request&, const web::Reply&);

private:
    web::Answer data(const web::Request&) const;
    web::Withdraw begin(const web::Request&, const web::Reply&);
    /// Returns the job with the examples added to its files, since the user's files may include them.
    std::string completed(const std::string& body) const;
    void keep(const std::string& job, const std::string& answer);

    Runs& runs_;
    Texts examples_;
    std::string keep_;
    std::uint64_t kept_ = 0;
    std::string page_, examples_json_, exercises_json_, catalogue_json_;
};

} // namespace placedpar::serve
