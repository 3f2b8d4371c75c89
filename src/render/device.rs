//! A device to draw with, where no window brings one.

use thiserror::Error;

/// There is no graphics driver to draw with.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[error(
    "no graphics driver can be used ({reason}); install one (without a graphics card: \
     `apt-get install libvulkan1 mesa-vulkan-drivers` on Debian, draws in software)"
)]
pub struct NoDriver {
    /// What the drivers say.
    pub reason: String,
}

/// Opens the best adapter that there is.
///
/// # Errors
/// [`NoDriver`]: none is there, or it does not open.
pub fn open_device() -> Result<(wgpu::Adapter, wgpu::Device, wgpu::Queue), NoDriver> {
    // OpenGL only where there is nothing else: looking for it takes time and makes some drivers talk.
    let backends = wgpu::Backends::from_env();
    let first = backends.unwrap_or(wgpu::Backends::PRIMARY);
    let second = backends.unwrap_or(wgpu::Backends::SECONDARY);
    pollster::block_on(async {
        match open(first).await {
            Err(_) if second != first => open(second).await,
            opened => opened,
        }
    })
    .map_err(|reason| NoDriver { reason: reason.lines().next().unwrap_or_default().trim().to_owned() })
}

async fn open(backends: wgpu::Backends) -> Result<(wgpu::Adapter, wgpu::Device, wgpu::Queue), String> {
    let mut descriptor = wgpu::InstanceDescriptor::new_without_display_handle_from_env();
    descriptor.backends = backends;
    let options = wgpu::RequestAdapterOptions {
        power_preference: wgpu::PowerPreference::HighPerformance,
        ..wgpu::RequestAdapterOptions::default()
    };
    let adapter = wgpu::Instance::new(descriptor).request_adapter(&options).await.map_err(|error| error.to_string())?;
    // Skins are moved there where it can compute; nothing else asks for more than the least that there is.
    let computes = adapter.get_downlevel_capabilities().flags.contains(wgpu::DownlevelFlags::COMPUTE_SHADERS);
    let least = if computes { wgpu::Limits::downlevel_defaults() } else { wgpu::Limits::downlevel_webgl2_defaults() };
    let descriptor = wgpu::DeviceDescriptor {
        label: Some("sinew"),
        required_limits: least.using_resolution(adapter.limits()),
        ..wgpu::DeviceDescriptor::default()
    };
    let (device, queue) = adapter.request_device(&descriptor).await.map_err(|error| error.to_string())?;
    Ok((adapter, device, queue))
}
