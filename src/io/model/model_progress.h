// How far the reading of a model is, told from any thread.
#pragma once

#include "model_source.h"

#include <teapath/core/error.h>

#include <algorithm>
#include <mutex>

namespace tp {

class ModelProgress {
public:
    explicit ModelProgress(const ModelSource& source) : source_(source) {}

    /// The part of the whole, from 0 to 1, that `steps` calls of step() make up from here on.
    void begin(double share, size_t steps) {
        const std::lock_guard lock(mutex_);
        at_ = end_;
        end_ += share;
        step_ = steps > 0 ? share / static_cast<double>(steps) : 0;
        tell();
    }
    void step() {
        const std::lock_guard lock(mutex_);
        at_ = std::min(at_ + step_, end_);  // the number of steps may be a guess
        tell();
    }

private:
    void tell() {
        if (source_.progress && !source_.progress(at_ < 1 ? at_ : 1.0))
            throw Error(ErrorKind::Input, "the reading was stopped", source_.name,
                        "open the model again");
    }

    const ModelSource& source_;
    std::mutex mutex_;
    double at_ = 0, end_ = 0, step_ = 0;
};

}  // namespace tp
