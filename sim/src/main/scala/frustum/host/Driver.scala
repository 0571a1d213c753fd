package frustum.host

import frustum.scene.{Camera, Scene}
import frustum.spec.{FramePass, RasterConfig, TextureUpload}

object Driver {
  def prepare(scene: Scene, camera: Camera, options: DrawOptions, config: RasterConfig, frame: Int): PreparedFrame = ???
  def commands(pass: FramePass): Seq[Seq[Int]] = ???
  def commands(upload: TextureUpload): Seq[Seq[Int]] = ???
}
