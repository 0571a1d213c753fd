package frustum.driver.raster

import frustum.contract.InputError
import frustum.contract.raster.{TexelFormat, TextureRef}
import frustum.driver.raster.Fixtures._
import frustum.driver.scene.{Material, TextureImage}
import frustum.scene.Pictures
import org.scalatest.funsuite.AnyFunSuite

class TextureMemoryTest extends AnyFunSuite {
  private def meshOf(materials: Material*) =
    scene(materials.indices.map(i => triangle(vertex(0, 0), vertex(9, 0), vertex(0, 9), i)), materials: _*)

  test("textures lie one after the other, each once") {
    val m = TextureMemory.allocate(meshOf(textured(8, 16), textured(128, 64), textured(8, 16)), config)
    assert(m.uploads.map(u => (u.base, u.texels.length)) == Seq((0, 128), (2, 8192)))
    assert(m.references(texture(128, 64)) == TextureRef(2, 7, 6, TexelFormat.Rgb565))
  }

  test("two of the largest fill the memory, a third is refused with the numbers") {
    def large(i: Int) =
      Material.textured(s"m$i", Pictures.opaque(128, 128)((x, y) => (i / 3.0, x / 128.0, y / 128.0)), 1)
    assert(TextureMemory.allocate(meshOf(large(0), large(1)), config).uploads.map(_.base) == Seq(0, 256))
    val error = intercept[InputError](TextureMemory.allocate(meshOf(large(0), large(1), large(2)), config))
    assert(error.message.contains("need 49152 texels, the memory has 32768"))
  }

  test("sizes the hardware does not take are refused by name") {
    for ((w, h) <- Seq((4, 8), (256, 8), (48, 64), (64, 100))) {
      val error = intercept[InputError](prepare(meshOf(textured(w, h))))
      assert(error.message.contains(s"'$w x $h' is $w x $h texels; each side must be 8, 16, 32, 64, 128"))
    }
  }

  test("the bottom row comes first") {
    val image = TextureImage(
      8,
      8,
      IndexedSeq.tabulate(64)(i => if (i >= 56) 0xffffffff else 0xff000000),
      hasAlpha = false
    )
    assert(TextureMemory.texels(image) == IndexedSeq.tabulate(64)(i => if (i < 8) 0xffff else 0))
  }

  test("colours round to the nearest level") {
    assert(TextureMemory.rgb565(0xffffffff) == 0xffff)
    assert(TextureMemory.rgb565(0xff800003) == (16 << 11))
    assert(TextureMemory.rgba4444(0x80ff0011) == 0xf018)
    val image = TextureImage(8, 8, IndexedSeq.fill(64)(0x80ff0011), hasAlpha = true)
    assert(
      TextureMemory.format(image) == TexelFormat.Rgba4444 && TextureMemory.texels(image).forall(_ == 0xf018)
    )
  }
}
