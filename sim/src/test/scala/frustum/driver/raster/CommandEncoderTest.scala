package frustum.driver.raster

import frustum.contract.raster.{Command, TextureUpload}
import frustum.driver.raster.Fixtures._
import frustum.scene.Scenes
import org.scalatest.funsuite.AnyFunSuite
import java.nio.file.Files

class CommandEncoderTest extends AnyFunSuite {
  test("every scene survives the wire") {
    for (
      name <- Scenes.names;
      pass <- prepare(Scenes.byName(name), options.copy(background = 0x7d7e7d), frame = 0x7e7d).passes
    ) {
      val bytes = Driver.commands(pass).flatten
      val (decoded, states) = WireDecoder.pass(WireDecoder.messages(bytes))
      assert(decoded == pass.copy(states = IndexedSeq.empty), name)
      assert(states == pass.states.map(_.words), name)
    }
  }

  test("one flag per command, and commands no longer than the table allows") {
    val pass = prepare(Scenes.teapot()).passes.head
    for (command <- Driver.commands(pass)) {
      assert(command.head == Command.Flag && command.tail.forall(_ != Command.Flag))
      assert(WireDecoder.messages(command).map(_.payload.length).forall(_ <= Command.MaxWords))
    }
  }

  test("textures arrive at their addresses") {
    val image = texture(128, 32)
    val upload = TextureUpload(7, TextureMemory.texels(image))
    val memory = Array.fill(32768)(-1)
    for (WireDecoder.Message(command, payload) <- WireDecoder.messages(Driver.commands(upload).flatten)) {
      assert(command == Command.Texels)
      payload.drop(1).zipWithIndex.foreach { case (texel, i) => memory(payload(0) * 16 + i) = texel }
    }
    assert(memory.slice(7 * 64, 7 * 64 + 4096).toSeq == upload.texels)
    assert(memory.count(_ >= 0) == 4096)
  }

  test("the file transport writes the bytes") {
    val file = Files.createTempFile("frustum", ".bin")
    try {
      val commands = Driver.commands(prepare(Scenes.cube).passes.head)
      val transport = new FileTransport(file)
      commands.foreach(transport.send)
      transport.close()
      assert(Files.readAllBytes(file).map(_ & 255).toSeq == commands.flatten)
    } finally Files.delete(file)
  }
}
