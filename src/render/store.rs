//! Buffers that grow.

/// A buffer that grows with what is written to it.
pub(super) struct Store {
    pub(super) buffer: wgpu::Buffer,
    pub(super) count: u32,
    label: &'static str,
    usage: wgpu::BufferUsages,
}

impl Store {
    pub(super) fn new(device: &wgpu::Device, label: &'static str, usage: wgpu::BufferUsages) -> Self {
        Self { buffer: make(device, label, usage, 256), count: 0, label, usage }
    }

    /// Writes rows of so many words each.
    pub(super) fn write(&mut self, device: &wgpu::Device, queue: &wgpu::Queue, words: &[u32], row: usize) {
        let bytes = size_of_val(words) as u64;
        if bytes > self.buffer.size() {
            self.buffer = make(device, self.label, self.usage, bytes.next_power_of_two());
        }
        queue.write_buffer(&self.buffer, 0, bytemuck::cast_slice(words));
        self.count = (words.len() / row) as u32;
    }
}

fn make(device: &wgpu::Device, label: &'static str, usage: wgpu::BufferUsages, size: u64) -> wgpu::Buffer {
    device.create_buffer(&wgpu::BufferDescriptor {
        label: Some(label),
        size,
        usage: usage | wgpu::BufferUsages::COPY_DST,
        mapped_at_creation: false,
    })
}
