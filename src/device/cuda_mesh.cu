#include <teapath/device/cuda_mesh.cuh>

namespace tp {
namespace {

constexpr size_t kAlignment = 256;

// Lays arrays out one after the other; the second time, copies them.
class Packer {
public:
    explicit Packer(std::byte* memory, const Stream& stream) : memory_(memory), stream_(stream) {}

    template <class T>
    Span<const T> add(const std::vector<T>& v) {
        if (v.empty()) return {};
        std::byte* place = memory_ + offset_;
        const size_t bytes = v.size() * sizeof(T);
        offset_ += (bytes + kAlignment - 1) / kAlignment * kAlignment;
        if (memory_)
            check(cudaMemcpyAsync(place, v.data(), bytes, cudaMemcpyHostToDevice, stream_.get()));
        return {reinterpret_cast<const T*>(place), static_cast<uint32_t>(v.size())};
    }

    MeshView add(const MeshArrays& m) {
        MeshView view;
        view.nodes = add(m.nodes);
        view.triangles = add(m.triangles);
        view.attributes = {add(m.normals).data,
                           add(m.tangents).data,
                           {add(m.uvs[0]).data, add(m.uvs[1]).data},
                           add(m.colors).data};
        return view;
    }

    size_t bytes() const { return offset_; }

private:
    std::byte* memory_;
    const Stream& stream_;
    size_t offset_ = 0;
};

}  // namespace

CudaMesh::CudaMesh(std::shared_ptr<const MeshArrays> arrays, const Stream& stream)
    : arrays_(std::move(arrays)) {
    Packer measure(nullptr, stream);
    measure.add(*arrays_);
    memory_.resize(measure.bytes());
    view_ = Packer(memory_.data(), stream).add(*arrays_);
    stream.wait();
}

}  // namespace tp
